// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// About how many bits the adaptive coding takes for a coefficient. The estimate is a geometric law
/// whose mean follows the two coefficients before and the two parents. A law learned from the
/// values would be nearer to the coded bits, but sweeps would end with 2 to 3 % more of them: rare
/// values would cost so much that no sweep would try them.
class RateTable {
 public:
  /// The bands must outlive the table.
  explicit RateTable(const std::vector<Band>& bands) : bands_(bands) {}

  /// The bits of coefficient `i` of band `b` > 0 if it were `value`. `signal` holds all
  /// coefficients.
  double bits(const int* signal, int b, int i, int value) const;

  /// The bits of a coefficient, were it one value or another, plus those of the coefficients that
  /// it is a neighbour of: looked up around it once, for several values.
  class Around {
   public:
    Around(const RateTable& table, const int* signal, int b, int i);
    double bits(int value) const;

   private:
    /// A coefficient whose mean follows this one's magnitude, besides what else it follows.
    struct Follower {
      int magnitude;
      int before, above;    // without this one's share
      int share_of_before;  // times its magnitude
      int share_of_above;
    };
    int before_;
    int above_;
    int count_ = 0;
    std::array<Follower, 6> followers_;
  };

  /// The bits of a difference between coarse samples.
  static double coarse_bits(int difference) {
    return 1 + 2 * std::log2(1.0 + 2 * std::abs(difference));
  }

  /// The bits of a whole signal.
  double bits(const int* signal) const;

 private:
  struct Neighbours {
    int before = 0;  // weighted magnitudes
    int above = 0;
  };
  Neighbours neighbours_of(const int* signal, int b, int i) const;
  bool is_zero(const int* signal, const Band& band) const;

  const std::vector<Band>& bands_;
};

}  // namespace mocapress
