// SPDX-License-Identifier: MIT
// Scalar tracks of a clip at frames and between them.
#pragma once

#include <optional>

#include "core/runtime/decode/signal_decoder.h"
#include "core/runtime/decode/track_block.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// Whether the tracks are the clip's, and none stands there twice.
bool is_possible(const mcpr_tracks& tracks, const mcpr_track_request& request);

class TrackDecoder {
 public:
  /// With measuring memory only to know how much.
  TrackDecoder(Memory& memory, const mcpr_tracks& tracks, const mcpr_track_request& request);

  std::size_t values_of_frame() const { return count_; }

  /// Rows of values_of_frame(). All frames exist.
  void decode(std::uint32_t first, std::uint32_t count, float* out);

  /// Between a frame and another, of which `share` is taken. `rows`: two of them, to work in.
  void sample_between(std::uint32_t frame, std::uint32_t next, float share, float* out);

 private:
  const ResidentTrack& track(std::size_t place) const;
  void put_held(std::size_t place, std::uint32_t first, std::uint32_t count, float* out) const;

  const mcpr_tracks& tracks_;
  const mcpr_track_request& request_;
  std::size_t count_;
  std::int32_t* columns_ = nullptr;  // of curves
  float* next_row_ = nullptr;
  std::optional<SignalDecoder> curves_;  // none is asked for: it is not needed
};

}  // namespace mocapress::runtime
