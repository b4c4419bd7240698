// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/compressed_clip.h"

namespace mocapress {

/// The motion of a compressed clip. Throws FormatError when its bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// A compressed clip before its correction.
struct Uncorrected {
  Clip clip;
  Eigen::MatrixXd differences;  // frames x 3 * effectors, cm: what the effectors lack
};

/// decode() in two steps. correct() does nothing without a correction.
Uncorrected decode_uncorrected(const CompressedClip& compressed);
CorrectionReport correct(const CompressedClip& compressed, const Eigen::MatrixXd& differences,
                         Clip& clip);

}  // namespace mocapress
