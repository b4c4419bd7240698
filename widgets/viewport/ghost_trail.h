// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/viewport/figure_shape.h"

namespace mocapress {

/// Which poses around now are drawn: those at whole multiples of `step`, so that they stand still
/// while the figure walks through them.
struct TrailPoses {
  int frame = 0;  // now
  int step = 1;   // frames
  int count = 0;  // before now, and after

  /// In the order of time, without now.
  std::vector<int> frames(int clip_frames) const;
};

struct TrailColours {
  QColor past;
  QColor future;
  QColor far;  // what the poses fade to with their distance in time
};

/// Those poses of a figure, its bones alone: many poses are drawn at once. tracks: frames x 3 *
/// landmarks, cm.
std::vector<Capsule> ghostTrail(const FigureShape& shape, const Eigen::MatrixXd& tracks,
                                const TrailPoses& poses, const TrailColours& colours);

}  // namespace mocapress
