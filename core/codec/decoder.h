// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/compressed_clip.h"

namespace mocapress {

/// The motion of a compressed clip. Throws FormatError when its bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// decode() in two steps, for those who want to see what the correction does.
Clip decode_uncorrected(const CompressedClip& compressed);
CorrectionReport correct(const CompressedClip& compressed, Clip& clip);

}  // namespace mocapress
