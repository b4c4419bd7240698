// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// The error of a clip over time, cm.
struct ErrorProfile {
  Eigen::VectorXf max;   // over all landmarks
  Eigen::VectorXf mean;  // over all landmarks

  int frames() const { return static_cast<int>(max.size()); }
};

/// Of distances (frames x landmarks, cm).
ErrorProfile errorProfile(const Eigen::MatrixXf& distances);

/// Frames at which the greatest error has a peak, the worst first, none nearer than `apart` frames
/// to a worse one, `most` at most.
std::vector<int> worstFrames(const Eigen::VectorXf& max, int apart, int most);

/// The next in that order; `step` -1: the one before. From a frame that is none of them: the worst.
int nextWorst(const std::vector<int>& worst, int frame, int step);

}  // namespace mocapress
