// SPDX-License-Identifier: MIT
// What bits at the ends of a clip are worth: ADAPTIVE.md, "Ends and loops".
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/wavelet/synthesis.h"

namespace mocapress {

/// Lest a clip begin or end with larger errors than it has elsewhere: bits there are cheaper while
/// the errors of its first or last few frames are larger than others, as dear as elsewhere where
/// they are smaller. Half as dear at first.
class EndPrices {
 public:
  static constexpr Eigen::Index kSeen = 4;    // frames at an end, by whose errors it is priced
  static constexpr Eigen::Index kReach = 16;  // frames at an end whose bits have its price
  static constexpr int kFewestFrames = 128;   // of a clip with such prices

  /// How much of a synthesis function lies at the first and at the last frames: shares of its
  /// energy.
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

  /// Of a bit of the coefficient whose function reaches so far, by what it would be elsewhere.
  double price(const Reach& reach, double elsewhere) const {
    double dearer = 1;
    for (std::size_t end = 0; end < reach.size(); ++end)
      dearer += (1 / shares_[end] - 1) * static_cast<double>(reach[end]);
    return elsewhere / dearer;
  }

  /// The squared errors of the first and of the last kSeen frames, and what so many frames have
  /// elsewhere. cm^2
  void observe(const std::array<double, 2>& energies, double usual) {
    constexpr double kLeast = 0.1;
    for (std::size_t end = 0; end < energies.size(); ++end)
      if (energies[end] > 0)
        shares_[end] = std::clamp(shares_[end] * std::sqrt(usual / energies[end]), kLeast, 1.0);
  }

 private:
  Eigen::Index frames_;
  std::array<double, 2> shares_ = {0.5, 0.5};  // of prices elsewhere, at the first and last frame
};

}  // namespace mocapress
