// SPDX-License-Identifier: MIT
#include "core/base/random.h"

#include <cassert>

namespace mocapress {

std::uint64_t Random::below(std::uint64_t bound) {
  assert(bound > 0);
  // Draws below 2^64 mod bound would favour small values: reject them.
  const std::uint64_t unfair = (0 - bound) % bound;
  std::uint64_t draw = engine_();
  while (draw < unfair) draw = engine_();
  return draw % bound;
}

double Random::unit() {
  constexpr double kTwoToMinus53 = 0x1p-53;
  return static_cast<double>(engine_() >> 11) * kTwoToMinus53;
}

}  // namespace mocapress
