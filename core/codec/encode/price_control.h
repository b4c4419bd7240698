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
  /// What the growth of eps_x does, in logarithms: about as clips of corpus/train from 0.1 to 0.5
  /// cm have it where single coefficients move, and a few others where all channels' do.
  struct Response {
    double kept;  // of a sweep's growth in the next at the same price
    double with_price;
    double least_with_price;
    double most_with_price;
  };
  static constexpr Response kSingle = {0.5, 0.045, 0.03, 0.08};
  static constexpr Response kTogether = {0.35, 0.15, 0.06, 0.25};

  /// The growth of eps_x in the last sweep, and how sweeps answer.
  PriceControl(double growth, const Response& response)
      : response_(response), slope_(response.with_price), growth_(growth) {}

  /// The factor by which to change the price.
  double factor_for(double growth) {
    constexpr double kMost = 0.7;  // a logarithm
    dearer_ = std::clamp((growth - response_.kept * growth_) / slope_, -kMost, kMost);
    return std::exp(dearer_);
  }

  void observe(double growth) {
    constexpr double kTells = 0.1;
    if (std::abs(dearer_) > kTells)
      slope_ = std::clamp((growth - response_.kept * growth_) / dearer_, response_.least_with_price,
                          response_.most_with_price);
    growth_ = growth;
  }

 private:
  Response response_;
  double slope_;
  double growth_;
  double dearer_ = 0;
};

}  // namespace mocapress
