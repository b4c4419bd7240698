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

/// Computes the profile from distances (frames x landmarks, cm).
ErrorProfile errorProfile(const Eigen::MatrixXf& distances);

/// Errors within a range of frames, over all landmarks, cm.
struct RangeErrors {
  double rms = 0;
  double p95 = 0;
  double max = 0;
  int frame = 0;     // where the maximum is
  int landmark = 0;  // landmark that has the maximum
};

/// Errors of the frames `first` to `last`, which must lie within the clip.
RangeErrors rangeErrors(const Eigen::MatrixXf& distances, int first, int last);

/// Frames at which `max` has a peak, worst first: at most `most` frames, each at least `apart`
/// frames away from any worse one.
std::vector<int> worstFrames(const Eigen::VectorXf& max, int apart, int most);

/// The entry of `worst` after `frame`, or the one before it if `step` is -1. A frame that is not in
/// the list leads to the worst.
int nextWorst(const std::vector<int>& worst, int frame, int step);

}  // namespace mocapress
