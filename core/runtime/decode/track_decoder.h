// SPDX-License-Identifier: MIT
// Decodes a clip's scalar tracks at frames and between them.
#pragma once

#include <optional>

#include "core/runtime/decode/signal_decoder.h"
#include "core/runtime/decode/track_block.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// True if all requested tracks exist, without duplicates, and the sample rate is not below zero.
bool is_possible(const mcpr_tracks& tracks, const mcpr_track_request& request);

class TrackDecoder {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  TrackDecoder(Memory& memory, const mcpr_tracks& tracks, const mcpr_track_request& request);

  std::size_t values_of_frame() const { return count_; }

  /// Decodes rows of values_of_frame() floats. All frames must exist.
  void decode(std::uint32_t first, std::uint32_t count, float* out);

  /// Interpolates between two frames; `share` is the weight of the second.
  void sample_between(std::uint32_t frame, std::uint32_t next, float share, float* out);

 private:
  const ResidentTrack& track(std::size_t place) const;
  void put_held(std::size_t place, std::uint32_t first, std::uint32_t count, float* out) const;

  const mcpr_tracks& tracks_;
  const mcpr_track_request& request_;
  std::size_t count_;
  std::int32_t* columns_ = nullptr;  // one per curve
  float* next_row_ = nullptr;
  std::optional<SignalDecoder> curves_;  // empty if the clip has no curves
};

}  // namespace mocapress::runtime
