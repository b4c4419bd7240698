// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/series_style.h"

#include "core/baselines/compression_method.h"
#include "widgets/models/palette.h"

namespace mocapress {

SeriesStyle seriesStyle(std::string_view method, bool feet_held) {
  const auto all = compression_methods();
  const CompressionMethod* compression_method = find_compression_method(method);
  const auto place =
      compression_method ? static_cast<std::size_t>(compression_method - all.data()) : all.size();
  return {QColor(kCurveColours[place % kCurveColours.size()]),
          static_cast<int>(place) % kSeriesShapes, feet_held || place >= kCurveColours.size(),
          feet_held};
}

}  // namespace mocapress
