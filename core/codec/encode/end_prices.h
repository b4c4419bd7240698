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

  explicit EndPrices(Eigen::Index frames) : frames_(frames) {}

  /// Of a bit of the coefficient with that function, by what it would be elsewhere: as far as the
  /// function lies at the ends.
  double price(const ShortFunction& function, double elsewhere) const {
    const auto frames_within = [&](Eigen::Index frames) {
      return std::clamp<Eigen::Index>(frames, 0, function.size());
    };
    const Eigen::Index at_first = frames_within(kReach - function.first());
    const Eigen::Index at_last = frames_within(function.end() + kReach - frames_);
    if (at_first == 0 && at_last == 0) return elsewhere;
    const Eigen::ArrayXf squares = function.values().square();
    const auto share = [&](float part) { return static_cast<double>(part / squares.sum()); };
    return elsewhere / (1 + (1 / shares_.front() - 1) * share(squares.head(at_first).sum()) +
                        (1 / shares_.back() - 1) * share(squares.tail(at_last).sum()));
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
