// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/options/encode_options.h"
#include "core/codec/encode/search/goal.h"

namespace mocapress {

/// The result of a search for a target.
struct TargetedEncoding {
  // The provenance is not set. A draft may have quantised values but no coded motion yet.
  CompressedClip compressed;
  int count = 0;                // of the coefficients kept
  double correction_ratio = 0;  // r_IK, given or found
  std::optional<double>
      slide_without_cm;  // slide of the encode without correction, where r_IK was found
  int iterations = 0;    // of the last annealing or closed loop
  bool complete = true;  // false: the observer stopped it
};

/// Searches the number of coefficients that meets the target; for a closed loop, the scale of its
/// steps. Where r_IK is left open, it also searches the split between motion and correction. Throws
/// TargetMissed if the target is out of reach, and Error for an impossible correction.
TargetedEncoding encode_to_target(const ClipAnalysis& analysis, const EncodeOptions& options,
                                  const Observer<EncodeProgress>& observer);

/// A closed loop at one scale, whatever the target, and the finest scale there is.
struct ScaleTrial {
  Trial trial;
  double finest_scale = 0;
};

/// A correction must have its ratio.
ScaleTrial encode_at_scale(const ClipAnalysis& analysis, const EncodeOptions& options, double scale,
                           ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                           const Observer<EncodeProgress>& observer);

/// ClosedLoop::coarsen() of a coded clip, without a target: to a bound for each frame.
Trial coarsen_to_bound(const ClipAnalysis& analysis, const EncodeOptions& options,
                       QuantisedSignals coded, const Eigen::VectorXd& bound_cm,
                       const Observer<EncodeProgress>& observer);

/// The r_IK that suits the target best, for options that leave it open.
double find_correction_split(const ClipAnalysis& analysis, const EncodeOptions& options);

}  // namespace mocapress
