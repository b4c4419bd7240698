// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/signal_decoder.h"

namespace mocapress::runtime {

/// Decodes windows of a clip's signals. A frame lies in one segment, or in two that overlap, whose
/// samples are then blended. Holds the decoders of at most two segments.
class SegmentDecoder {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  SegmentDecoder(Memory& memory, const ClipBlock& clip, const SignalRequest& request);

  /// Decodes frames first ... first + count - 1 into rows that are out_step apart. 0 < count <=
  /// kWindow, and all frames must exist.
  void decode_window(int first, int count, float* out, std::ptrdiff_t out_step);

 private:
  /// A segment that is being decoded. Its decoder lies in the caller's memory, because it is too
  /// large for the stack.
  struct SegmentSlot {
    std::byte* memory = nullptr;  // the decoder and its work space
    int segment = -1;
    SignalDecoder* decoder = nullptr;
  };

  void make_of(int segment, int first, int count, float* out, std::ptrdiff_t out_step);
  void blend(int shared, int count, float* out, std::ptrdiff_t out_step) const;

  const ClipBlock& clip_;
  SignalRequest request_;
  std::uint64_t slot_bytes_ = 0;
  SegmentSlot slots_[2];         // for segments with even and with odd numbers
  float* later_rows_ = nullptr;  // rows of the later segment in an overlap
};

}  // namespace mocapress::runtime
