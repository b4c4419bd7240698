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
  /// The growth of eps_x in the last sweep.
  explicit PriceControl(double growth) : growth_(growth) {}

  /// The factor by which to change the price.
  double factor_for(double growth) {
    constexpr double kMost = 0.7;  // a logarithm
    dearer_ = std::clamp((growth - kKept * growth_) / slope_, -kMost, kMost);
    return std::exp(dearer_);
  }

  void observe(double growth) {
    constexpr double kTells = 0.1;
    if (std::abs(dearer_) > kTells)
      slope_ = std::clamp((growth - kKept * growth_) / dearer_, kLeastWithPrice, kMostWithPrice);
    growth_ = growth;
  }

 private:
  // What the growth of eps_x does, in logarithms: about as clips of corpus/train have it from 0.1
  // to 0.5 cm.
  static constexpr double kKept = 0.35;  // of a sweep's growth in the next at the same price
  static constexpr double kWithPrice = 0.15;
  static constexpr double kLeastWithPrice = 0.06;
  static constexpr double kMostWithPrice = 0.25;

  double growth_;
  double slope_ = kWithPrice;
  double dearer_ = 0;
};

}  // namespace mocapress
