// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/format/tracks_section.h"

namespace mocapress {

/// Codes tracks so that no decoded value differs by more than `bound`. Tracks that are constant or
/// jump now and then are stored exactly, and so are those that no wavelet brings within the bound.
CodedTracks encode_tracks(const ScalarTracks& tracks, double bound);

/// Encodes the tracks and adds them to a file: with_coded_tracks().
std::vector<std::byte> with_tracks(std::span<const std::byte> mcpr, const ScalarTracks& tracks,
                                   double bound);

}  // namespace mocapress
