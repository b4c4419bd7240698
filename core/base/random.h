// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

namespace mocapress {

/// A seeded generator whose draws are the same on every platform, which the distributions of the
/// standard library do not promise. Passed by reference, never global.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, bound). Requires bound > 0.
  std::uint64_t below(std::uint64_t bound);

  /// Uniform in [0, 1).
  double unit();

 private:
  std::mt19937_64 engine_;
};

}  // namespace mocapress
