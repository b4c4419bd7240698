// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/codec/encode/search/goal.h"

namespace mocapress {

/// Searches the number of coefficients that meets the target; for a closed loop, the scale of its
/// steps. Where r_IK is left open, it also searches the split between motion and correction. Throws
/// TargetMissed if the target is out of reach, and Error for an impossible correction.
Trial encode_to_target(const ClipAnalysis& analysis, const EncodeSettings& settings,
                       const Observer<EncodeProgress>& observer);

/// A closed loop at one scale, whatever the target, and the finest scale there is.
struct ScaleTrial {
  Trial trial;
  double finest_scale = 0;
};

/// A correction must have its ratio.
ScaleTrial encode_at_scale(const ClipAnalysis& analysis, const EncodeSettings& settings,
                           double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                           const Observer<EncodeProgress>& observer);

/// ClosedLoop::coarsen() of a coded clip, without a target: to a bound for each frame.
Trial coarsen_to_bound(const ClipAnalysis& analysis, const EncodeSettings& settings,
                       QuantisedSignals coded, const Eigen::VectorXd& bound_cm,
                       const Observer<EncodeProgress>& observer);

/// The r_IK that suits the target best, for settings that leave it open.
double find_correction_split(const ClipAnalysis& analysis, const EncodeSettings& settings);

}  // namespace mocapress
