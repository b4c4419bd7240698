// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/motion/clip.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

/// What an error d of a signal costs: sum_t place_t d_t^2 + step_t (d_t - d_(t-1))^2. The second
/// part is what makes a foot that stands slide, though it be near its place.
struct FitWeights {
  Eigen::VectorXd place;
  Eigen::VectorXd step;  // of frame 0: nothing
};

/// Some wavelet coefficients of some signals, in whole steps. As in QuantisedSignals a signal's
/// step is divided by Lifting::gains() in every band.
struct DifferenceFit {
  Eigen::ArrayXX<bool> kept;  // coefficients x signals, coarse to fine
  Eigen::VectorXd steps;      // of each signal, cm
  Eigen::MatrixXi values;     // zero where not kept
};

/// The largest step a coding has that is not above the one wished for.
using CodedStep = std::function<double(double step)>;

/// `count` coefficients in all, chosen and given values so that the signals they make cost little.
/// The largest with their own values would do for signals whose basis is orthonormal and whose
/// frames are all alike; these are neither. For the same reason they are not rounded each to the
/// nearest step: a value makes good what the rounding of its neighbours cost. Requires one weight
/// for each signal.
DifferenceFit fit_differences(const Clip& columns, const std::vector<FitWeights>& weights,
                              Basis basis, int count, const CodedStep& coded_step);

}  // namespace mocapress
