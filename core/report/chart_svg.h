// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/report/curve.h"
#include "core/report/report_language.h"

namespace mocapress {

struct ChartSeries {
  std::string title;
  int style = 0;  // colour and marker: 0 to kChartStyles - 1
  Curve line;
  Curve markers;       // at the measured points
  bool paper = false;  // true: published values, drawn as hollow markers without a line
};

inline constexpr int kChartStyles = 12;

/// A rate-distortion chart. The compression ratio is on the horizontal axis and eps_x on the
/// vertical one, both logarithmic.
struct Chart {
  std::string label;   // text for screen readers
  double width = 720;  // px
  double height = 430;
  bool direct_labels = false;  // true: series have their titles at the lines' ends
  std::vector<ChartSeries> series;
};

/// Draws a chart as an inline <svg>. The classes of report_style.h give the colours.
std::string draw(const Chart& chart, const ReportLanguage& say = {});

/// Draws the line and marker of a style for a legend.
std::string legend_mark(int style);

}  // namespace mocapress
