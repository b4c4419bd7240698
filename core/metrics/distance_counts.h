// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mocapress {

/// How many of many distances are about how large, in memory that does not grow with them: a
/// count for each 4096th of an octave, in the octaves there are.
class DistanceCounts {
 public:
  static constexpr double kPrecision = 1.0 / 4096;

  void add(float distance);

  /// The smallest distance that at least `share` of all do not exceed, or up to kPrecision of it
  /// less. 0 where there are none.
  double percentile(double share) const;

 private:
  static constexpr int kBits = 12;                       // of a float's fraction
  std::array<std::vector<std::uint64_t>, 256> octaves_;  // by the exponent of a float
  std::uint64_t all_ = 0;
};

}  // namespace mocapress
