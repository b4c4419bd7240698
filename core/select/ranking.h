// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 4.

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

/// Coefficients with each channel's order of importance. The largest has the largest product of
/// |coefficient| and the L2 norm of its synthesis function, since the basis is not normalised.
struct RankedCoefficients : Coefficients {
  Eigen::MatrixXd importance;  // |value| x norm, same shape as the values
  std::vector<std::vector<int>>
      by_importance;  // for each channel: coefficient indices, largest first
};

/// Transforms and sorts every channel, in parallel.
RankedCoefficients rank_coefficients(const Clip& clip, Basis basis);

/// The number of coefficients that each channel keeps, its largest ones: the paper's vector m.
using Kept = std::vector<int>;

/// The coefficients of trunc(theta_c, kept) for every channel: all but the largest are zero.
Eigen::MatrixXd truncate(const RankedCoefficients& ranked, const Kept& kept);

/// The signal (one value a frame) from the coefficients of `channel` ranked [first, last).
Eigen::VectorXd synthesise(const RankedCoefficients& ranked, int channel, int first, int last);

/// The paper's first approach: `count` coefficients in all, equally many for every channel. If
/// `count` is no multiple of the channels, the first channels keep one more.
Kept keep_per_channel(const RankedCoefficients& ranked, int count);

/// The paper's standard wavelet compression. The order of all coefficients of all channels is found
/// once; each count then takes a prefix of it.
class StandardOrder {
 public:
  StandardOrder(const RankedCoefficients& ranked, const Skeleton& skeleton);

  /// For signals of any kind; each has a scale that multiplies its importance.
  StandardOrder(const RankedCoefficients& ranked, const std::vector<double>& scales);

  /// The `count` largest coefficients of all: the paper's vector w. Requires 0 <= count <=
  /// ranked.total().
  Kept keep(int count) const;

 private:
  int channels_;
  // Channels of the largest, second largest, ... coefficient.
  std::vector<int> channel_by_importance_;
};

/// Factors that make angles comparable with translations: the length (cm) of the bone each channel
/// drives, and 1 for translations. A joint that drives no bone of any length, as an ASF's root,
/// counts as the longest.
std::vector<double> channel_scales(const Skeleton& skeleton);

}  // namespace mocapress
