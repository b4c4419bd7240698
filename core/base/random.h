// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstdint>
#include <random>

namespace mocapress {

/// A seeded generator that draws the same numbers on every platform; the standard library's
/// distributions do not promise that. Passed by reference, never global.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, bound). Requires bound > 0.
  std::uint64_t below(std::uint64_t bound) {
    assert(bound > 0);
    // The first 2^64 mod bound numbers would make some results more likely: draw again.
    const std::uint64_t unfair = (0 - bound) % bound;
    std::uint64_t draw = engine_();
    while (draw < unfair) draw = engine_();
    return draw % bound;
  }

  /// Uniform in [0, 1).
  double unit() {
    constexpr double kTwoToMinus53 = 0x1p-53;
    return static_cast<double>(engine_() >> 11) * kTwoToMinus53;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mocapress
