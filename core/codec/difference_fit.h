// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/select/ranking.h"

namespace mocapress {

/// What an error d of a signal costs: sum_t place_t d_t^2 + step_t (d_t - d_(t-1))^2. The second
/// part is what makes a foot that stands slide, though it be near its place.
struct FitWeights {
  Eigen::VectorXd place;
  Eigen::VectorXd step;  // of frame 0: nothing
};

/// Some coefficients of some signals, and what they should be.
struct CoefficientFit {
  RankedCoefficients ranked;  // the fitted values, those kept first
  Kept kept;

  std::vector<double> scales() const { return std::vector<double>(kept.size(), 1.0); }
};

/// `count` coefficients in all, chosen and given values so that the signals they make cost little.
/// The largest with their own values would do for signals whose basis is orthonormal and whose
/// frames are all alike; these are neither. Requires one weight for each signal.
CoefficientFit fit_coefficients(const Clip& columns, const std::vector<FitWeights>& weights,
                                Basis basis, int count);

}  // namespace mocapress
