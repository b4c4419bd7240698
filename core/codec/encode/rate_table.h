// SPDX-License-Identifier: MIT
#pragma once

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

  /// The same, plus the bits of the coefficients that it is a neighbour of. `signal` is unchanged
  /// on return.
  double bits_around(int* signal, int b, int i, int value) const;

  /// The bits of a difference between coarse samples.
  static double coarse_bits(int difference) {
    return 1 + 2 * std::log2(1.0 + 2 * std::abs(difference));
  }

  /// The bits of a whole signal.
  double bits(const int* signal) const;

 private:
  bool is_zero(const int* signal, const Band& band) const;

  const std::vector<Band>& bands_;
};

}  // namespace mocapress
