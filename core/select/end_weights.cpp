// SPDX-License-Identifier: MIT
#include "core/select/end_weights.h"

#include <cmath>

namespace mocapress {

Eigen::VectorXd end_weights(int frames, double sample_rate_hz) {
  // An end counts as much as so many seconds of the rest. The last frame, which may have to be
  // guessed from those before, takes more than the first (fitted on corpus/train).
  constexpr double kFirstSeconds = 0.05;
  constexpr double kLastSeconds = 0.35;
  constexpr double kReach = 2;  // frames in which that falls to 1 / e
  Eigen::VectorXd weights(frames);
  for (int t = 0; t < frames; ++t)
    weights(t) = 1 + sample_rate_hz * (kFirstSeconds * std::exp(-t / kReach) +
                                       kLastSeconds * std::exp((t - (frames - 1)) / kReach));
  return weights;
}

}  // namespace mocapress
