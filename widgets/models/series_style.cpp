// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/series_style.h"

#include "core/compare/contender.h"
#include "widgets/models/palette.h"

namespace mocapress {

SeriesStyle seriesStyle(std::string_view method, bool feet_held) {
  const auto all = contenders();
  const Contender* contender = find_contender(method);
  const auto place = contender ? static_cast<std::size_t>(contender - all.data()) : all.size();
  return {QColor(kCurveColours[place % kCurveColours.size()]),
          static_cast<int>(place) % kSeriesShapes, feet_held || place >= kCurveColours.size(),
          feet_held};
}

}  // namespace mocapress
