// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// A frame at which a point of the decoded clip jumps off its path and back. People notice such
/// frames first, and mean errors hide them.
struct Glitch {
  int frame = 0;
  int landmark = 0;
  double cm = 0;  // distance from the mean of the errors before and after

  bool operator==(const Glitch&) const = default;
};

/// Frames at which a landmark's error is `least_cm` or more from the mean of the errors before and
/// after, and further than in the frames beside. They are in order of time, each with the landmark
/// that jumps furthest. Jumps of the original itself do not count. Tracks as from
/// landmark_tracks(), equal in shape.
std::vector<Glitch> find_glitches(const Eigen::MatrixXd& original_tracks,
                                  const Eigen::MatrixXd& decoded_tracks, double least_cm = 0.5);

}  // namespace mocapress
