// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// A frame at which a point of the decoded clip jumps out of its way and back: what the eye catches
/// first, and what means hide.
struct Glitch {
  int frame = 0;
  int landmark = 0;
  double cm = 0;  // off the middle of the error before and after

  bool operator==(const Glitch&) const = default;
};

/// Frames whose error stands out from both neighbours' by `least_cm` or more, in the order of time,
/// each by the landmark that jumps furthest. What the original does itself is no error. Tracks as
/// landmark_tracks() gives them, equal in shape.
std::vector<Glitch> find_glitches(const Eigen::MatrixXd& original_tracks,
                                  const Eigen::MatrixXd& decoded_tracks, double least_cm = 0.5);

}  // namespace mocapress
