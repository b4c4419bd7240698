// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/compressed_clip.h"

namespace mocapress {

/// The motion of a compressed clip. Throws FormatError when its bytes are not valid.
Clip decode(const CompressedClip& compressed);

}  // namespace mocapress
