// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// About how many bits the adaptive coding takes for a coefficient, by its band, the two before it
/// and its two parents: a still picture of what the coding learns, quick to look up.
class RateTable {
 public:
  /// The bands must outlive the table. It is of use after learn().
  explicit RateTable(const std::vector<Band>& bands);

  /// Counts how often each value occurs beside which neighbours.
  void learn(const Eigen::MatrixXi& values);

  /// Of coefficient `i` of band `b` > 0, were it `value`. `signal` holds all coefficients.
  double bits(const int* signal, int b, int i, int value) const {
    return bits_in(context(signal, b, i), value);
  }

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
  int context(const int* signal, int b, int i) const;
  double bits_in(int context, int value) const;
  bool is_zero(const int* signal, const Band& band) const;

  const std::vector<Band>& bands_;
  std::vector<double> bits_;  // [context][magnitude]
};

}  // namespace mocapress
