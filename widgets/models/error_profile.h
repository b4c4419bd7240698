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
  int landmark = 0;  // likewise
};

/// Requires that the range is within the clip.
RangeErrors rangeErrors(const Eigen::MatrixXf& distances, int first, int last);

/// Frames at which the maximum has a peak, worst first: at most `most`, and each at least `apart`
/// frames away from any worse one.
std::vector<int> worstFrames(const Eigen::VectorXf& max, int apart, int most);

/// The next frame of `worst`, or the one before for `step` -1. A frame outside the list leads to
/// the worst.
int nextWorst(const std::vector<int>& worst, int frame, int step);

}  // namespace mocapress
