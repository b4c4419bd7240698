// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/signal_decoder.h"

namespace mocapress::runtime {

/// Signals of a clip, window by window, whichever segments they are in: where two overlap, a blend
/// of both. Works in the memory of two segments at most.
class SegmentDecoder {
 public:
  /// With measuring memory only to know how much.
  SegmentDecoder(Memory& memory, const ClipBlock& clip, const SignalRequest& request);

  /// Rows of frames first ... first + count - 1, out_step apart. 0 < count <= kWindow, and all
  /// frames exist.
  void decode_window(int first, int count, float* out, std::ptrdiff_t out_step);

 private:
  /// One segment being decoded, for as long as it is in use. Where there is but one, its memory is
  /// not kept apart.
  struct SegmentSlot {
    std::byte* memory = nullptr;
    int segment = -1;
    std::optional<SignalDecoder> decoder;
  };

  void make_of(int segment, int first, int count, float* out, std::ptrdiff_t out_step);
  void blend(int shared, int count, float* out, std::ptrdiff_t out_step) const;

  const ClipBlock& clip_;
  SignalRequest request_;
  std::uint64_t slot_bytes_ = 0;
  SegmentSlot slots_[2];         // of segments of even and of odd number
  float* later_rows_ = nullptr;  // of frames that two segments share
};

}  // namespace mocapress::runtime
