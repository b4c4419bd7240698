// SPDX-License-Identifier: MIT
// The price of a bit at the ends of a clip: ADAPTIVE.md, "Ends and loops".
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/wavelet/synthesis.h"

namespace mocapress {

/// Prices bits near a clip's ends so that the first and last frames are no worse than the rest.
/// Bits near an end start at half price. They get cheaper while the errors at that end are larger
/// than elsewhere, and dearer, up to the usual price, while these are smaller.
class EndPrices {
 public:
  static constexpr Eigen::Index kSeen = 4;    // frames at an end whose errors set its price
  static constexpr Eigen::Index kReach = 16;  // frames at an end to which its price applies
  static constexpr int kFewestFrames = 128;   // shorter clips have no such prices

  /// Shares of a synthesis function's energy within kReach frames of the first and of the last
  /// frame.
  using Reach = std::array<float, 2>;

  explicit EndPrices(Eigen::Index frames) : frames_(frames) {}

  Reach reach_of(const ShortFunction& function) const {
    const auto frames_within = [&](Eigen::Index frames) {
      return std::clamp<Eigen::Index>(frames, 0, function.size());
    };
    const Eigen::Index at_first = frames_within(kReach - function.first());
    const Eigen::Index at_last = frames_within(function.end() + kReach - frames_);
    if (at_first == 0 && at_last == 0) return {};
    const Eigen::ArrayXf squares = function.values().square();
    return {squares.head(at_first).sum() / squares.sum(),
            squares.tail(at_last).sum() / squares.sum()};
  }

  /// The price of a bit for a coefficient with this reach, given the price elsewhere.
  double price(const Reach& reach, double elsewhere) const {
    double dearer = 1;
    for (std::size_t end = 0; end < reach.size(); ++end)
      dearer += (1 / shares_[end] - 1) * static_cast<double>(reach[end]);
    return elsewhere / dearer;
  }

  /// Updates the prices. `energies` are the squared errors of the first and the last kSeen frames,
  /// `usual` is that of kSeen average frames, all in cm^2.
  void observe(const std::array<double, 2>& energies, double usual) {
    constexpr double kLeast = 0.01;
    constexpr double kFollow = 0.75;  // fitted to study and training clips: ADAPTIVE.md
    for (std::size_t end = 0; end < energies.size(); ++end)
      if (energies[end] > 0)
        shares_[end] =
            std::clamp(shares_[end] * std::pow(usual / energies[end], kFollow), kLeast, 1.0);
  }

 private:
  Eigen::Index frames_;
  std::array<double, 2> shares_ = {
      0.5, 0.5};  // prices at the first and last frame, as shares of those elsewhere
};

}  // namespace mocapress
