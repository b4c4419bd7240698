// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/format/tracks_section.h"

namespace mocapress {

/// Codes tracks so that no decoded value is further off than `bound`. Tracks that stay where
/// they are, or jump now and then, come back bit for bit, and so do those that no wavelet brings
/// within the bound.
CodedTracks encode_tracks(const ScalarTracks& tracks, double bound);

/// with_coded_tracks() of that.
std::vector<std::byte> with_tracks(std::span<const std::byte> mcpr, const ScalarTracks& tracks,
                                   double bound);

}  // namespace mocapress
