// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace mocapress::runtime {

/// A contiguous run of coefficients of one scale.
struct Band {
  int first;
  int size;
};

inline constexpr int kCoarsest = 4;    // shorter signals are not split further
inline constexpr int kMostBands = 32;  // a signal of 2^28 samples has 27

constexpr int evens_in(int length) {
  return (length + 1) / 2;
}
constexpr int odds_in(int length) {
  return length / 2;
}

/// 2^(count / 2), correctly rounded.
inline double power_of_root_two(int count) {
  return std::ldexp(count % 2 == 0 ? 1 : 0x1.6a09e667f3bcdp+0, count >> 1);
}

/// The bands of a signal of a given length, coarse to fine: first the coarse samples, fewer than
/// kCoarsest, then bands of details, each of which doubles the resolution.
struct Bands {
  int count = 0;
  Band band[kMostBands] = {};

  Bands() = default;
  explicit constexpr Bands(int length) {
    int finer = 0;
    for (int rest = length; rest >= kCoarsest; rest = evens_in(rest)) ++finer;
    count = finer + 1;
    int rest = length;
    for (; finer > 0; --finer, rest = evens_in(rest)) band[finer] = {evens_in(rest), odds_in(rest)};
    band[0] = {0, rest};
  }

  const Band& operator[](int b) const { return band[b]; }

  /// Length of the signal that bands 0 ... b reconstruct.
  int length(int b) const { return band[b].first + band[b].size; }

  /// Quantisation steps are divided by 2^(depth / 2). The finest details have depth 1, and each
  /// coarser band has one more; the coarse samples share the depth of the coarsest details.
  int depth(int b) const { return count == 1 ? 0 : count - (b > 1 ? b : 1); }
};

}  // namespace mocapress::runtime
