// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/motion/clip.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

/// The cost of an error d of a signal: sum_t place_t d_t^2 + step_t (d_t - d_(t-1))^2. The second
/// part is for planted feet: a foot near its place may still slide.
struct FitWeights {
  Eigen::VectorXd place;
  Eigen::VectorXd step;  // the entry of frame 0 is not used
};

/// Selected wavelet coefficients of signals, in whole steps. As in QuantisedSignals, a signal's
/// step is divided by Lifting::gains() in every band.
struct DifferenceFit {
  Eigen::ArrayXX<bool> kept;  // coefficients x signals, coarse to fine
  Eigen::VectorXd steps;      // one for each signal, cm
  Eigen::MatrixXi values;     // zero where not kept
};

/// Returns the largest step that the coding can store and that is not above `step`.
using CodedStep = std::function<double(double step)>;

/// Chooses `count` coefficients in total, and their values, so that the resulting signals cost
/// little. With an orthonormal basis and equal weights, the largest coefficients with their own
/// values would be best; neither holds here. For the same reason values are not rounded to the
/// nearest step: each makes up for the rounding of its neighbours. Requires one weight for each
/// signal.
DifferenceFit fit_differences(const Clip& columns, const std::vector<FitWeights>& weights,
                              Basis basis, int count, const CodedStep& coded_step);

}  // namespace mocapress
