// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QCustomPlot;

namespace mocapress {

/// Axes, grid and background in the palette of the widget the plot is in: call again when that
/// changes.
void applyPalette(QCustomPlot* plot);

}  // namespace mocapress
