// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "core/codec/format/tracks_section.h"

namespace mocapress {

/// Decodes the values of all tracks, bit by bit as the runtime decoder does.
ScalarTracks decode_tracks(const CodedTracks& coded);

/// Decodes the tracks of a .mcpr file of any method; empty if the file has none. Throws
/// FormatError.
ScalarTracks tracks_of(std::span<const std::byte> mcpr);

/// Returns the largest difference between two values, which is how the error of tracks is measured.
/// Both must have the same tracks and frames.
double track_error(const ScalarTracks& original, const ScalarTracks& decoded);

}  // namespace mocapress
