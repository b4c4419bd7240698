// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/compressed_clip.h"

namespace mocapress {

/// The motion of a compressed clip, in the channels of its skeleton. Throws FormatError when its
/// bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// A compressed clip, or some frames of it, before its correction: in the channels that are coded.
struct Uncorrected {
  Clip clip;
  Eigen::MatrixXd differences;  // frames x 3 * effectors, cm: what the effectors lack
};

/// decode() in two steps. correct() does nothing without a correction.
Uncorrected decode_uncorrected(const CompressedClip& compressed);
CorrectionReport correct(const CompressedClip& compressed, const Eigen::MatrixXd& differences,
                         Clip& clip);

/// The frames from first_frame on, which may be changed or taken.
using DecodedBlock = std::function<void(int first_frame, Uncorrected& block)>;

/// decode_uncorrected() in time, segment after segment, so that they are never all in memory. A
/// clip that is not in segments comes at once.
void visit_decoded(const CompressedClip& compressed, const DecodedBlock& visit);

/// A clip in the channels that are coded, in those of the skeleton.
Clip in_source_channels(const CompressedClip& compressed, Clip coded);

/// Puts some rows where they belong in a matrix of so many.
void put_rows(Eigen::MatrixXd rows, int first, int all, Eigen::MatrixXd& matrix);

}  // namespace mocapress
