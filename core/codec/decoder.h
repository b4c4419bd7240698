// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/codec/compressed_clip.h"

namespace mocapress {

/// The motion of a compressed clip. Throws FormatError when its bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// One signal a column, from the words of FORMAT.md's MOTN. Throws FormatError.
Eigen::MatrixXd decode_signals(std::span<const std::byte> bytes, Coding coding, Basis basis,
                               int frames, int signals);

}  // namespace mocapress
