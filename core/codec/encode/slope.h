// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/codec/encode/encoder.h"

namespace mocapress {

/// Size and errors of a compressed clip.
struct Standing {
  double bytes = 0;          // of the motion
  double eps_cm = 0;         // in the settings' weighting
  Eigen::ArrayXd joints_cm;  // RMS distance of each joint's points, over the frames

  /// RMS distance of some joints; 0 for none.
  double cm_of(const std::vector<int>& joints) const;
};

/// Requires a distortion with distances.
Standing standing_of(const Skeleton& skeleton, const Distortion& distortion, Weighting weighting,
                     std::size_t motion_bytes);

/// Changed settings, and the result of encoding the clip with them.
struct Slope {
  EncodeSettings settings;
  Standing standing;
};

/// Allows some joints `times` as large an error, while the others keep about theirs: divides the
/// weights of these joints by times^2, and raises the target by as much as the others would gain.
/// Promises about the joints are raised, too. The target keeps its kind, except that MaxError and
/// Visibility become Error, and CoefficientRatio becomes Ratio. Throws like Encoder::encode().
Slope relax(const Encoder& encoder, const EncodeSettings& settings, const Standing& now,
            const std::vector<int>& joints, double times,
            const Observer<EncodeProgress>& observer = {});

/// Takes `times` as many bytes for the motion. The target becomes one that this encoding just
/// meets; its kind changes as in relax().
Slope resize(const Encoder& encoder, const EncodeSettings& settings, const Standing& now,
             double times, const Observer<EncodeProgress>& observer = {});

}  // namespace mocapress
