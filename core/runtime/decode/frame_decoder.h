// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/segment_decoder.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// Whether a clip can fulfil a request.
bool is_possible(const ClipBlock& clip, const mcpr_request& request);

/// Floats in a frame of a possible request's output.
std::size_t values_of_frame(const ClipBlock& clip, const mcpr_request& request);

/// Of what the first and the last frame lack.
struct EndShares {
  float of[kMostEnds] = {};
};

/// Plays frames of a clip as a request wants them.
class FrameDecoder {
 public:
  /// Of a possible request. With measuring memory only to know how much.
  FrameDecoder(Memory& memory, const ClipBlock& clip, const mcpr_request& request);

  /// Frames first ... first + count - 1, which exist.
  void decode(int first, int count, float* out);

  /// An instant between 0 and the last frame.
  void sample_at(double frame, float* out);

  /// So far on the way from the last frame to the first, of a loop.
  void decode_across(float share, float* out);

 private:
  /// A row of the synthesis: channels, then what the correction adds. Corrects it in place.
  void correct(float* row);
  void put_out(float* row, const EndShares& shares, float* out);

  /// How much of what the ends lack goes to a frame, or to an instant between it and the next.
  EndShares shares_at(int frame, float share_of_next = 0) const;
  void add_ends(const EndShares& shares, float* row) const;
  void put_out_local(const float* row, float* out) const;
  void put_out_positions(const float* row, float* out) const;
  SignalRequest signal_request(Memory& memory);
  bool is_plain() const { return !solves_ && request_.output == MCPR_CHANNELS; }

  const ClipBlock& clip_;
  const mcpr_request& request_;
  const bool solves_;
  const bool picks_;  // the subset stands in rows of all channels
  std::int32_t* columns_ = nullptr;
  SegmentDecoder signals_;
  Limb limb_;
  JointPlace* places_;  // of all joints
  std::ptrdiff_t row_step_;
  float* rows_;  // where frames are not put out as they are
};

}  // namespace mocapress::runtime
