// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/skeleton.h"
#include "core/motion/source_format.h"

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

/// `count` frames of a motion, from `first` on.
Motion frames_of(const Motion& motion, int first, int count);

/// True if each channel keeps its value over all frames, up to rounding (1e-6 cm or radians).
std::vector<bool> still_channels(const Clip& clip);

/// Adds whole turns to each rotation channel, so that no step between frames exceeds half a turn.
/// A wavelet would otherwise spend its bits on jumps that move nothing.
void unwrap_angles(const Skeleton& skeleton, Clip& clip);

/// The same motion in other axes. From Z up to Y up, x y z become x z -y, as in Blender. Channels
/// only change places and signs, so that going there and back gives the same numbers.
Motion with_up_axis(const Motion& motion, UpAxis from, UpAxis to);

}  // namespace mocapress
