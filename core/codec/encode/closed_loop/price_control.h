// SPDX-License-Identifier: MIT
// Steers the settling of the closed loop to the wanted eps_x: ADAPTIVE.md, "Let prices come to
// rest".
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// Predicts the bit price at which the next sweep changes eps_x by a wanted amount. Two effects
/// count: part of the last sweep's growth continues at the same price, and eps_x grows with the
/// price at a rate that differs from clip to clip and is learned on the way. Assuming too small a
/// rate would make prices swing without converging.
class PriceControl {
 public:
  /// `growth`: log(eps_x after / before the last sweep).
  explicit PriceControl(double growth) : growth_(growth) {}

  /// The factor by which to multiply the price so that the next sweep has this growth (a
  /// logarithm).
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
  // Response of eps_x, in logarithms: typical of corpus/train from 0.1 to 0.5 cm.
  static constexpr double kKept = 0.35;  // share of a sweep's growth that recurs at the same price
  static constexpr double kWithPrice = 0.15;
  static constexpr double kLeastWithPrice = 0.06;
  static constexpr double kMostWithPrice = 0.25;

  double growth_;
  double slope_ = kWithPrice;
  double dearer_ = 0;
};

}  // namespace mocapress
