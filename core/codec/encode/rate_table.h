// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// About how many bits the adaptive coding takes for a coefficient, by the two before it and its
/// two parents: a geometric law whose mean follows them. Learned from the values themselves it
/// would come nearer to the bits that are coded, and yet sweeps would leave 2 to 3 % more of them:
/// what is rare already would be so dear that none would try it.
class RateTable {
 public:
  /// The bands must outlive the table.
  explicit RateTable(const std::vector<Band>& bands) : bands_(bands) {}

  /// Of coefficient `i` of band `b` > 0, were it `value`. `signal` holds all coefficients.
  double bits(const int* signal, int b, int i, int value) const;

  /// The same with those of the coefficients that it is a neighbour of. `signal` is as before on
  /// return.
  double bits_around(int* signal, int b, int i, int value) const;

  /// Of a difference between coarse samples.
  static double coarse_bits(int difference) {
    return 1 + 2 * std::log2(1.0 + 2 * std::abs(difference));
  }

  /// Of a whole signal.
  double bits(const int* signal) const;

 private:
  bool is_zero(const int* signal, const Band& band) const;

  const std::vector<Band>& bands_;
};

}  // namespace mocapress
