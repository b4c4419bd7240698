// SPDX-License-Identifier: MIT
// How even samples predict an odd one: FORMAT.md, "The transform". The same for the encoder's
// transform and the synthesis of an engine.
#pragma once

#include <algorithm>

#include "core/runtime/format/kinds.h"

namespace mocapress::runtime {

inline constexpr int kMostNeighbours = 4;

/// The even samples that predict an odd one.
struct Neighbours {
  int first;
  int count;
};

/// Of odd sample `odd`, which lies between even samples `odd` and `odd + 1`. One after the last
/// even sample goes on from two: a cubic through four would make 3.4 times their errors of it.
constexpr Neighbours neighbours_of(Wavelet wavelet, int odd, int evens) {
  if (wavelet == Wavelet::Haar) return {odd, 1};
  const bool within = wavelet == Wavelet::Cubic && odd + 1 < evens;
  const int count = std::min(within ? kMostNeighbours : 2, evens);
  return {std::clamp(odd + 1 - count / 2, 0, evens - count), count};
}

/// Their weights: the Lagrange polynomial through them, where the odd sample is.
template <typename Real>
void weights_of(Wavelet wavelet, int odd, const Neighbours& neighbours, Real* weights) {
  const Real position =
      wavelet == Wavelet::Haar ? Real{0} : static_cast<Real>(odd - neighbours.first) + Real{0.5};
  for (int i = 0; i < neighbours.count; ++i) {
    Real weight = 1;
    for (int j = 0; j < neighbours.count; ++j)
      if (j != i) weight *= (position - static_cast<Real>(j)) / static_cast<Real>(i - j);
    weights[i] = weight;
  }
}

/// The same away from the borders: of the two samples beside it, and of the two beyond.
struct InnerWeights {
  double near;
  double far;
};

constexpr InnerWeights inner_weights(Wavelet wavelet) {
  return wavelet == Wavelet::Cubic ? InnerWeights{9.0 / 16, -1.0 / 16} : InnerWeights{0.5, 0};
}

}  // namespace mocapress::runtime
