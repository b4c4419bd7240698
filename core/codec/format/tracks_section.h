// SPDX-License-Identifier: MIT
// The section `trks` of a .mcpr file: FORMAT.md. The section says nothing about the motion, so that
// the reader and the writer of clips need not know it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/format/quantised_signals.h"
#include "core/motion/scalar_track.h"
#include "core/runtime/format/signal_neighbours.h"

namespace mocapress {

/// ScalarTracks as stored in a file. A track is held, with exact values in `tracks`, or it is a
/// curve, with its quantised signal in `curves`.
struct CodedTracks {
  ScalarTracks tracks;
  std::vector<bool> is_curve;  // one for each track
  Basis basis = Basis::Cubic;
  QuantisedSignals curves;  // one signal for each curve, in the order of the tracks
};

/// Codes the curves alone.
std::vector<std::byte> curve_bytes(const QuantisedSignals& curves);

/// Estimates the bits of a track's values if it is held.
std::size_t held_bits(const ScalarTrack& track);

/// Returns the file with the section at its end, in place of an existing one; without tracks the
/// section is left out. Requires a whole file as write_container() makes it. Throws Error for more
/// tracks, frames or bytes of a name than the format has room for, and for values that are not
/// finite.
std::vector<std::byte> with_coded_tracks(std::span<const std::byte> mcpr,
                                         const CodedTracks& tracks);

/// Reads the section; empty if the file lacks it. Throws FormatError.
CodedTracks coded_tracks_of(std::span<const std::byte> mcpr);

/// The bytes of tracks in a file: the section with its head.
std::size_t track_bytes_of(std::span<const std::byte> mcpr);

}  // namespace mocapress
