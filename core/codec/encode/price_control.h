// SPDX-License-Identifier: MIT
// How a settling of the closed loop comes to its error: ADAPTIVE.md, "Prices that come to rest".
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// What a bit must be worth for eps_x to grow by so much in the next sweep. By the growth of the
/// sweep before, of which a part goes on at the same price, and by how much eps_x has grown with
/// the price: that differs from clip to clip and is learned on the way. With less than there is,
/// prices would go up and down for ever without coming to the error.
class PriceControl {
 public:
  /// The growth of eps_x in the last sweep. All growths are logarithms.
  explicit PriceControl(double growth) : growth_(growth) {}

  /// The factor by which to change the price.
  double factor_for(double growth) {
    constexpr double kMost = 0.7;  // a logarithm
    dearer_ = std::clamp((growth - kKept * growth_) / slope_, -kMost, kMost);
    return std::exp(dearer_);
  }

  void observe(double growth) {
    constexpr double kTells = 0.1;
    constexpr double kLeastSlope = 0.03;
    constexpr double kMostSlope = 0.08;
    if (std::abs(dearer_) > kTells)
      slope_ = std::clamp((growth - kKept * growth_) / dearer_, kLeastSlope, kMostSlope);
    growth_ = growth;
  }

 private:
  // About, as clips of corpus/train from 0.1 to 0.5 cm have it.
  static constexpr double kKept = 0.5;
  double slope_ = 0.045;
  double growth_;
  double dearer_ = 0;
};

}  // namespace mocapress
