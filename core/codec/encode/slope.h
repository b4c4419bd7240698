// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/codec/encode/encoder.h"

namespace mocapress {

/// The figures of a clip as it is compressed.
struct Standing {
  double bytes = 0;          // the motion's
  double eps_cm = 0;         // in the settings' weighting
  Eigen::ArrayXd joints_cm;  // RMS distance of each joint's points, over the frames

  /// RMS of some joints; 0 for none.
  double cm_of(const std::vector<int>& joints) const;
};

/// Requires a distortion with distances.
Standing standing_of(const Skeleton& skeleton, const Distortion& distortion, Weighting weighting,
                     std::size_t motion_bytes);

/// A change of the settings, and what it comes to by an encode of the clip.
struct Slope {
  EncodeSettings settings;
  Standing standing;
};

/// Lets some joints be `times` as far off, while the others stay about as near as they are: a
/// weight is divided by times^2, and the target is raised by what the others would gain otherwise.
/// Promises about these joints are raised, too. The target keeps its kind, but one by the worst
/// frame becomes an error. Throws like Encoder::encode().
Slope relax(const Encoder& encoder, const EncodeSettings& settings, const Standing& now,
            const std::vector<int>& joints, double times,
            const Observer<EncodeProgress>& observer = {});

/// Takes `times` as many bytes for the motion. A target that is an error keeps being one.
Slope resize(const Encoder& encoder, const EncodeSettings& settings, const Standing& now,
             double times, const Observer<EncodeProgress>& observer = {});

}  // namespace mocapress
