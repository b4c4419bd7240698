// SPDX-License-Identifier: MIT
#include "core/runtime/decode/segment_decoder.h"

#include <algorithm>
#include <new>

namespace mocapress::runtime {

float share_of_later(const SegmentLayout& layout, int shared) {
  return static_cast<float>(shared + 1) / static_cast<float>(layout.overlap + 1);
}

float blended(float earlier, float later, float share_of_later) {
  const float difference = later - earlier;
  return earlier + share_of_later * difference;
}

SegmentDecoder::SegmentDecoder(Memory& memory, const ClipBlock& clip, const SignalRequest& request)
    : clip_(clip), request_(request) {
  Memory measuring;
  measuring.take<SignalDecoder>(1);
  const SignalDecoder largest(measuring, clip.largest, request);
  slot_bytes_ = measuring.used();
  slots_[0].memory = memory.take<std::byte>(slot_bytes_);
  if (clip.segments.count() == 1) return;
  slots_[1].memory = memory.take<std::byte>(slot_bytes_);
  later_rows_ = memory.take<float>(static_cast<std::uint64_t>(kWindow) *
                                   static_cast<std::uint64_t>(request.columns));
}

void SegmentDecoder::make_of(int segment, int first, int count, float* out,
                             std::ptrdiff_t out_step) {
  SegmentSlot& slot = slots_[segment % 2];
  if (slot.segment != segment) {
    Memory memory(slot.memory, static_cast<std::size_t>(slot_bytes_));
    auto* const place = memory.take<SignalDecoder>(1);
    slot.decoder = new (place) SignalDecoder(memory, clip_.motion(segment), request_);
    slot.segment = segment;
  }
  slot.decoder->decode_window(first - clip_.segments.first(segment), count, out, out_step);
}

void SegmentDecoder::decode_window(int first, int count, float* out, std::ptrdiff_t out_step) {
  while (count > 0) {
    const SegmentLayout::Stretch stretch = clip_.segments.stretch_at(first);
    const int frames = std::min(count, stretch.frames);
    if (stretch.shared < 0) {
      make_of(stretch.segment, first, frames, out, out_step);
    } else {
      make_of(stretch.segment - 1, first, frames, out, out_step);
      make_of(stretch.segment, first, frames, later_rows_, request_.columns);
      blend(stretch.shared, frames, out, out_step);
    }
    first += frames;
    count -= frames;
    out += frames * out_step;
  }
}

void SegmentDecoder::blend(int shared, int count, float* out, std::ptrdiff_t out_step) const {
  const float* later = later_rows_;
  for (int t = 0; t < count; ++t, out += out_step, later += request_.columns) {
    const float share = share_of_later(clip_.segments, shared + t);
    for (int c = 0; c < request_.columns; ++c) out[c] = blended(out[c], later[c], share);
  }
}

}  // namespace mocapress::runtime
