// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/constant_value.h"

#include <algorithm>
#include <cmath>

#include "core/runtime/format/coefficient_coder.h"
#include "core/runtime/format/interpolation.h"

namespace mocapress {
namespace {

/// Returns whether samples of this value predict exactly this value, with sums in the order of
/// FORMAT.md.
bool predicts_itself(float value) {
  constexpr auto kCubic = runtime::Wavelet::Cubic;
  const runtime::InnerWeights inner = runtime::inner_weights(kCubic);
  const float two = value + value;
  if (static_cast<float>(inner.near) * two + static_cast<float>(inner.far) * two != value)
    return false;
  constexpr int kMostEvens = runtime::kMostNeighbours;
  for (int evens = 1; evens <= kMostEvens; ++evens)
    for (int odd = 0; odd < evens; ++odd) {
      float weights[runtime::kMostNeighbours] = {};
      runtime::weights_of(kCubic, odd, runtime::neighbours_of(kCubic, odd, evens), weights);
      const float first = weights[0] * value + weights[1] * value;
      const float last = weights[2] * value + weights[3] * value;
      if (first + last != value) return false;
    }
  return true;
}

}  // namespace

int steps_of_constant(double value, double step) {
  if (value < 0) return -steps_of_constant(-value, step);
  constexpr int kTries = 64;
  constexpr double kMost = runtime::kMostSteps - kTries;
  const auto nearest = static_cast<int>(std::lround(std::clamp(value / step, -kMost, kMost)));
  for (int off = 0; off < kTries; ++off)
    for (const int steps : {nearest + off, nearest - off})
      if (predicts_itself(static_cast<float>(steps) * static_cast<float>(step))) return steps;
  return nearest;
}

}  // namespace mocapress
