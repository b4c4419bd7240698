// SPDX-License-Identifier: MIT
#include "core/codec/target.h"

#include <cmath>

namespace mocapress {

bool reached(const Target& target, double achieved) {
  constexpr double kRatioTolerance = 0.02;
  constexpr double kRounding = 1e-9;
  switch (target.kind) {
    case Target::Kind::Ratio:
      return std::abs(achieved / target.value - 1) <= kRatioTolerance + kRounding;
    case Target::Kind::CoefficientRatio:
      return achieved > 0;
    default:
      return achieved <= target.value * (1 + kRounding);
  }
}

}  // namespace mocapress
