// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "core/codec/format/tracks_section.h"

namespace mocapress {

/// The values of all tracks, as the runtime decoder gives them, to the bit.
ScalarTracks decode_tracks(const CodedTracks& coded);

/// Those of a .mcpr file of any method; none where it has none. Throws FormatError.
ScalarTracks tracks_of(std::span<const std::byte> mcpr);

/// The largest difference of a value: what a track error is. Both have the same tracks and frames.
double track_error(const ScalarTracks& original, const ScalarTracks& decoded);

}  // namespace mocapress
