// SPDX-License-Identifier: MIT
// The section `trks` of a .mcpr file: FORMAT.md. It says nothing of the motion, so that the reader
// and the writer of clips need not know it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/format/quantised_signals.h"
#include "core/motion/scalar_track.h"
#include "core/runtime/format/signal_neighbours.h"

namespace mocapress {

/// ScalarTracks as they are in a file. Those that are held have their values, bit for bit; curves
/// have none but their signals.
struct CodedTracks {
  ScalarTracks tracks;
  std::vector<bool> is_curve;  // of each
  Basis basis = Basis::Cubic;
  QuantisedSignals curves;  // in the order of the tracks; of their values' length
};

/// The coded curves alone.
std::vector<std::byte> curve_bytes(const QuantisedSignals& curves);

/// How many bits the values of a track take where it is held, about.
std::size_t held_bits(const ScalarTrack& track);

/// The file with the section at its end, in place of one it had; without, where there are no
/// tracks. Wants a whole file as write_container() makes it. Throws Error for more tracks, frames
/// or bytes of a name than the format has room for, and for values that are not finite.
std::vector<std::byte> with_coded_tracks(std::span<const std::byte> mcpr,
                                         const CodedTracks& tracks);

/// What the section says; nothing where there is none. Throws FormatError.
CodedTracks coded_tracks_of(std::span<const std::byte> mcpr);

/// The bytes that a file has of tracks: the section, its head and all.
std::size_t track_bytes_of(std::span<const std::byte> mcpr);

}  // namespace mocapress
