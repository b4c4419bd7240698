// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress::runtime {

/// A contiguous run of coefficients of one scale.
struct Band {
  int first;
  int size;
};

inline constexpr int kCoarsest = 4;    // a signal shorter than this is not split further
inline constexpr int kMostBands = 32;  // a signal of 2^28 samples has 27

constexpr int evens_in(int length) {
  return (length + 1) / 2;
}
constexpr int odds_in(int length) {
  return length / 2;
}

/// The bands of signals of one length, coarse to fine: first the coarse samples, fewer than 4, then
/// the details that double the resolution, again and again.
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

  /// The length of the signal that bands 0 ... b make up.
  int length(int b) const { return band[b].first + band[b].size; }

  /// Steps are divided by 2^(depth / 2): 1 for the finest details, one more for each coarser band,
  /// for the coarse samples as for the coarsest details.
  int depth(int b) const { return count == 1 ? 0 : count - (b > 1 ? b : 1); }
};

}  // namespace mocapress::runtime
