// SPDX-License-Identifier: MIT
// Prediction of odd samples from even ones: FORMAT.md, "The transform". Shared by the encoder's
// transform and the decoder's synthesis.
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

/// Neighbours of odd sample `odd`, which lies between even samples `odd` and `odd + 1`. An odd
/// sample after the last even one is extrapolated from two even ones: a cubic through four would
/// amplify their errors 3.4 times.
constexpr Neighbours neighbours_of(Wavelet wavelet, int odd, int evens) {
  if (wavelet == Wavelet::Haar) return {odd, 1};
  const bool within = wavelet == Wavelet::Cubic && odd + 1 < evens;
  const int count = std::min(within ? kMostNeighbours : 2, evens);
  return {std::clamp(odd + 1 - count / 2, 0, evens - count), count};
}

/// Prediction weights: those of the Lagrange polynomial through the neighbours, evaluated at the
/// odd sample.
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

/// Prediction weights away from the borders: of the two nearest even samples, and of the two beyond
/// them.
struct InnerWeights {
  double near;
  double far;
};

constexpr InnerWeights inner_weights(Wavelet wavelet) {
  return wavelet == Wavelet::Cubic ? InnerWeights{9.0 / 16, -1.0 / 16} : InnerWeights{0.5, 0};
}

}  // namespace mocapress::runtime
