// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// Frames of a clip that get more care: an error there counts `factor` times as much as elsewhere,
/// so that a target which is an error is as many times stricter there.
struct ImportantRange {
  int first_frame = 0;
  int last_frame = 0;  // included
  double factor = 1;   // 1 to kMostRangeFactor

  bool operator==(const ImportantRange&) const = default;
};

inline constexpr double kMostRangeFactor = 100;

/// The factor of each frame, the largest where ranges overlap; empty without ranges. Throws Error
/// for a factor out of bounds and for frames that the clip does not have.
Eigen::VectorXd frame_factors(const std::vector<ImportantRange>& ranges, int frames);

/// The parts of the ranges that lie within `count` frames from `first` on, counted from there.
std::vector<ImportantRange> frames_of(const std::vector<ImportantRange>& ranges, int first,
                                      int count);

}  // namespace mocapress
