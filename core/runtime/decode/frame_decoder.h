// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/segment_decoder.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/place_in_clip.h"

namespace mocapress::runtime {

/// True if a clip can fulfil a request.
bool is_possible(const ClipBlock& clip, const mcpr_request& request);

/// Floats per frame of output. The request must be possible.
std::size_t values_of_frame(const ClipBlock& clip, const mcpr_request& request);

/// Computes the world transform of all joints from one row of channels.
void place_joints(const ClipBlock& clip, const float* row, JointPlace* places);

/// Weights of the end corrections at an instant.
struct EndShares {
  float of[kMostEnds] = {};
};

/// Decodes frames of a clip as a request asks.
class FrameDecoder {
 public:
  /// The request must be possible. If `memory` only measures, this counts bytes and does nothing
  /// else.
  FrameDecoder(Memory& memory, const ClipBlock& clip, const mcpr_request& request);

  /// Decodes frames first ... first + count - 1, which must exist.
  void decode(int first, int count, float* out);

  /// Decodes the pose at any instant of the clip.
  void sample_at(const PlaceInClip& place, float* out);

 private:
  /// Decodes an instant between the last frame and the first frame of the next cycle. `share` is
  /// the position between the two, 0 ... 1.
  void decode_across(float share, float* out);

  /// Applies the IK correction to a row in place. The row holds channels, then effector offsets.
  void correct(float* row);
  void put_out(float* row, const EndShares& shares, float* out);

  /// Weights of the end corrections at a frame, or at an instant `share_of_next` after it.
  EndShares shares_at(int frame, float share_of_next = 0) const;
  void add_ends(const EndShares& shares, float* row) const;
  void put_out_local(const float* row, float* out) const;
  void put_out_positions(const float* row, float* out) const;
  SignalRequest signal_request(Memory& memory);
  bool is_plain() const { return !solves_ && request_.output == MCPR_CHANNELS; }

  const ClipBlock& clip_;
  const mcpr_request& request_;
  const bool solves_;
  const bool picks_;  // true: the IK correction needs all channels, of which the output is a subset
  std::int32_t* columns_ = nullptr;
  SegmentDecoder signals_;
  Limb limb_;
  JointPlace* places_;  // one per joint
  std::ptrdiff_t row_step_;
  float* rows_;  // work space: rows as decoded, before the correction and the conversion to the
                 // output
};

}  // namespace mocapress::runtime
