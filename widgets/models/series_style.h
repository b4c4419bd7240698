// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <string_view>

namespace mocapress {

/// What tells the series of a study apart, in every plot and table the same: colour, shape of the
/// points and kind of line, so that colour is never needed alone.
struct SeriesStyle {
  QColor colour;
  int shape = 0;        // of the points, 0 to kSeriesShapes - 1
  bool dashed = false;  // the line
  bool hollow = false;  // the points: with the feet held
};

inline constexpr int kSeriesShapes = 5;

/// By the method's place among compression_methods().
SeriesStyle seriesStyle(std::string_view method, bool feet_held);

}  // namespace mocapress
