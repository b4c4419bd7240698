// SPDX-License-Identifier: MIT
// A clip's scalar tracks in one block of bytes without pointers. The block is part of a resident
// clip. Cooking copies it unchanged into the cooked clip.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/runtime/decode/resident_signals.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/track_records.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// A track in the block.
struct ResidentTrack {
  std::uint32_t node = 0;  // this and the next: offsets of the two names in the block's names
  std::uint32_t name = 0;
  std::uint32_t first = 0;  // number of the curve, or of the track's first run
  std::uint32_t run_count = 0;
  std::uint8_t kind = 0;
  std::uint8_t is_curve = 0;
  std::uint8_t steps = 0;
  std::uint8_t padding = 0;
};

}  // namespace mocapress::runtime

struct mcpr_tracks {
  std::uint32_t bytes;  // size of the whole block, names and curves included
  std::uint32_t frames;
  std::uint32_t count;
  std::uint32_t curve_count;
  std::uint32_t run_count;
  std::uint32_t name_bytes;
  std::uint32_t tracks;  // ResidentTrack array; this and the next three are offsets from the block
  std::uint32_t names;   // zero-terminated
  std::uint32_t runs;    // TrackRun array
  std::uint32_t curves;  // ResidentSignals; 0: there are no curves
  mocapress::runtime::LoopKind loop;
  std::uint8_t padding[7];

  template <typename T>
  const T* at(std::uint32_t offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + offset);
  }
  const mocapress::runtime::ResidentTrack& track(std::size_t number) const {
    return at<mocapress::runtime::ResidentTrack>(tracks)[number];
  }
  /// The run of a held (piecewise constant) track that contains a frame.
  const mocapress::runtime::TrackRun* run_at(const mocapress::runtime::ResidentTrack& track,
                                             std::uint32_t frame) const {
    const auto* const first = at<mocapress::runtime::TrackRun>(runs) + track.first;
    return std::partition_point(first, first + track.run_count,
                                [&](const auto& run) { return run.end <= frame; });
  }
  float held(const mocapress::runtime::ResidentTrack& track, std::uint32_t frame) const {
    return run_at(track, frame)->value;
  }
  const mocapress::runtime::ResidentSignals& signals() const {
    return *at<mocapress::runtime::ResidentSignals>(curves);
  }
};

namespace mocapress::runtime {

/// True if a block from an untrusted source can be decoded without reading outside its `bytes`.
bool are_sound(const mcpr_tracks& tracks, std::uint64_t bytes);

}  // namespace mocapress::runtime
