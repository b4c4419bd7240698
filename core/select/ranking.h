// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/clip.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

/// A clip's wavelet coefficients.
struct Coefficients {
  Lifting lifting;
  Eigen::MatrixXd values;  // coefficients x channels, coarse to fine

  int channels() const { return static_cast<int>(values.cols()); }
  int per_channel() const { return static_cast<int>(values.rows()); }
  int total() const { return static_cast<int>(values.size()); }
};

/// Transforms every channel, in parallel.
Coefficients transform(const Clip& clip, Basis basis);

/// And for each channel their order of importance. "Largest" means |coefficient| x the L2 norm of
/// its synthesis function, as the basis is not normalised.
struct RankedCoefficients : Coefficients {
  Eigen::MatrixXd importance;  // |value| x norm, same shape as the values
  std::vector<std::vector<int>>
      by_importance;  // for each channel: coefficient indices, largest first
};

/// Transforms and sorts every channel, in parallel.
RankedCoefficients rank_coefficients(const Clip& clip, Basis basis);

/// How many of its largest coefficients each channel keeps: the paper's vector m.
using Kept = std::vector<int>;

/// trunc(theta_c, kept) for every channel, still as coefficients: the others are zero.
Eigen::MatrixXd truncate(const RankedCoefficients& ranked, const Kept& kept);

/// The signal (one value a frame) of the coefficients of `channel` ranked [first, last).
Eigen::VectorXd synthesise(const RankedCoefficients& ranked, int channel, int first, int last);

}  // namespace mocapress
