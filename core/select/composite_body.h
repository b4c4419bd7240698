// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6 (composite rigid
// bodies).
#pragma once

#include <Eigen/Core>
#include <array>

namespace mocapress {

/// Places or axes over some frames: three columns of numbers.
using ThreeColumns = std::array<const double*, 3>;

/// Landmarks with weights w and places x that move as one body, at up to kFrames frames: the sums
/// of w, w x and w x x^T.
struct CompositeBody {
  static constexpr int kFrames = 64;  // few enough for the first-level cache
  using Column = std::array<double, kFrames>;

  double mass = 0;
  std::array<Column, 3> moment{};
  std::array<Column, 3> square{};  // xx yy zz
  std::array<Column, 3> mixed{};   // yz zx xy

  /// Adds a landmark. Places are relative to `origin`.
  void add(double weight, const ThreeColumns& places, const ThreeColumns& origin, int frames);
  void add(const CompositeBody& other, int frames);

  /// The body with places relative to `place`.
  CompositeBody seen_from(const ThreeColumns& place, const ThreeColumns& origin, int frames) const;
};

}  // namespace mocapress
