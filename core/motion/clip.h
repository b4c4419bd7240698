// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/motion/skeleton.h"

namespace mocapress {

/// Motion over time: the paper's Theta(t), sampled.
struct Clip {
  double sample_rate_hz = 120.0;
  // frames x channels; a column is one channel over time (cm or radians), contiguous in memory
  Eigen::MatrixXd channels;

  int frames() const { return static_cast<int>(channels.rows()); }
  double seconds() const { return frames() / sample_rate_hz; }
};

/// A clip with the skeleton its channels belong to.
struct Motion {
  Skeleton skeleton;
  Clip clip;
};

/// Adds whole turns to each rotation channel so that no step between frames exceeds half a turn:
/// a wavelet would otherwise spend its bits on jumps that move nothing.
void unwrap_angles(const Skeleton& skeleton, Clip& clip);

}  // namespace mocapress
