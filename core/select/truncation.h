// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 4.
#pragma once

#include "core/select/ranking.h"

namespace mocapress {

/// The paper's first approach: `count` coefficients in all, as many from every channel. Where
/// `count` is no multiple of the channels, the first channels keep one more.
Kept keep_per_channel(const RankedCoefficients& ranked, int count);

/// The paper's standard wavelet compression. The order of all coefficients of all channels is
/// found once; each count is then a prefix of it.
class StandardOrder {
 public:
  StandardOrder(const RankedCoefficients& ranked, const Skeleton& skeleton);

  /// With channels made comparable by these factors.
  StandardOrder(const RankedCoefficients& ranked, const std::vector<double>& scales);

  /// The `count` largest of all: the paper's vector w. Requires 0 <= count <= ranked.total().
  Kept keep(int count) const;

 private:
  int channels_;
  std::vector<int> channel_by_importance_;  // the channel of the largest, second largest, ...
};

/// What makes angles comparable with translations: the length (cm) of the bone each channel drives,
/// 1 for translations. Root bones of ASF have no length; what drives none counts as the longest.
std::vector<double> channel_scales(const Skeleton& skeleton);

}  // namespace mocapress
