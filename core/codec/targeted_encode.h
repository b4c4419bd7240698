// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/clip_analysis.h"
#include "core/codec/encoder.h"

namespace mocapress {

/// What a search for a target came to.
struct TargetedEncoding {
  CompressedClip compressed;    // without its provenance
  int count = 0;                // of the coefficients kept
  double correction_ratio = 0;  // r_IK, asked for or found
  int iterations = 0;           // of the last annealing or closed loop
  bool complete = true;         // false: the observer ended it early
};

/// Searches the number of coefficients, or of a closed loop the scale of its steps, that meets the
/// target, and the split between motion and correction where that is left open. Throws TargetMissed
/// when the target is out of reach, and Error for a correction that cannot be.
TargetedEncoding encode_to_target(const ClipAnalysis& analysis, const EncodeOptions& options,
                                  const Observer<EncodeProgress>& observer);

/// The contacts that count: edited ones, or those found on the original.
const std::vector<ContactSpan>& contacts_for(const ClipAnalysis& analysis,
                                             const EncodeOptions& options);

}  // namespace mocapress
