// SPDX-License-Identifier: MIT
// The coded motion of a segment: FORMAT.md, "Adaptive coding".
#pragma once

#include "core/runtime/format/coefficient_coder.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

/// Quantisation step of a signal: scale * 2^(-step_exponent / 2).
double step_of(int step_exponent, float scale);

/// Reads the scale of the quantisation steps, which comes first in the coded motion.
float read_scale(Cursor& coded);

/// Decodes the scale of the quantisation steps, and the coefficients of all signals of `view`.
/// First resets the model and the notes. `learned` is PRIO of a packed clip: learned_priors.h. With
/// `bands_left_out`, the bytes end before the finest bands.
mcpr_result decode_coefficients(const Bytes& coded, const SignalNeighbours* neighbours,
                                const Bands& bands, CoefficientModel& model,
                                const QuantisedView& view, const CoderNotes& notes, float& scale,
                                const Bytes& learned = {}, int bands_left_out = 0);

}  // namespace mocapress::runtime
