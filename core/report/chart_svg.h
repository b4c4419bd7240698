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
  Curve markers;       // measured points
  bool paper = false;  // published figures: drawn as hollow markers without a line
};

inline constexpr int kChartStyles = 12;

/// A rate-distortion chart: compression ratio across, eps_x upwards, both logarithmic.
struct Chart {
  std::string label;   // text for screen readers
  double width = 720;  // px
  double height = 430;
  bool direct_labels = false;  // labels the lines at their ends
  std::vector<ChartSeries> series;
};

/// Returns an inline <svg>, coloured by the classes of report_style.h.
std::string draw(const Chart& chart, const ReportLanguage& say = {});

/// A series' mark for a legend.
std::string legend_mark(int style);

}  // namespace mocapress
