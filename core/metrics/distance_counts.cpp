// SPDX-License-Identifier: MIT
#include "core/metrics/distance_counts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mocapress {
namespace {

constexpr int kFraction = 23;  // bits of a float

}  // namespace

void DistanceCounts::add(float distance) {
  // Ordered as the floats are, where these are not negative.
  const auto bits = std::bit_cast<std::uint32_t>(distance) & 0x7FFFFFFFU;
  std::vector<std::uint64_t>& octave = octaves_[bits >> kFraction];
  if (octave.empty()) octave.resize(1U << kBits);
  ++octave[(bits >> (kFraction - kBits)) & ((1U << kBits) - 1)];
  ++all_;
}

double DistanceCounts::percentile(double share) const {
  const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(all_)));
  std::uint64_t below = 0;
  for (std::uint32_t exponent = 0; exponent < octaves_.size(); ++exponent)
    for (std::uint32_t part = 0; part < octaves_[exponent].size(); ++part) {
      below += octaves_[exponent][part];
      if (below >= std::max<std::uint64_t>(rank, 1))
        return std::bit_cast<float>(exponent << kFraction | part << (kFraction - kBits));
    }
  return 0;
}

}  // namespace mocapress
