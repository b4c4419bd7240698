// SPDX-License-Identifier: MIT
// Divides the frames of a long clip into overlapping segments: FORMAT.md, SEGS.
#pragma once

#include <algorithm>
#include <cstdint>

namespace mocapress::runtime {

inline constexpr std::uint32_t kLeastSegment = 256;  // frames; each segment has a fixed cost

/// Segments of `length` frames; the last may be shorter. Neighbours share `overlap` frames. A
/// single segment has the length of the clip, and no overlap.
struct SegmentLayout {
  int frames = 0;  // frames of the clip
  int length = 0;
  int overlap = 0;

  static constexpr SegmentLayout whole(int frames) { return {frames, frames, 0}; }

  constexpr int hop() const { return length - overlap; }
  constexpr int count() const {
    return frames <= length ? 1 : 1 + (frames - length + hop() - 1) / hop();
  }
  constexpr int first(int segment) const { return segment * hop(); }
  constexpr int frames_of(int segment) const { return std::min(length, frames - first(segment)); }

  /// Total frames of all segments. Frames that two segments share count twice.
  constexpr std::int64_t coded_frames() const {
    return frames + static_cast<std::int64_t>(count() - 1) * overlap;
  }

  /// Consecutive frames that lie in the same segment, or in the same two segments.
  struct Stretch {
    int segment;  // number of the segment; the later one of two
    int frames;   // number of frames, from the requested one on
    int shared;   // position in the overlap with the previous segment, from 0 on; -1: not in an
                  // overlap
  };
  constexpr Stretch stretch_at(int frame) const {
    const int segment = hop() > 0 ? std::min(frame / hop(), count() - 1) : 0;
    const int into = frame - first(segment);
    if (segment > 0 && into < overlap) return {segment, overlap - into, into};
    const int next = segment + 1 < count() ? first(segment + 1) : frames;
    return {segment, next - frame, -1};
  }
};

/// True if a file may have this layout: at least two segments, and no frame in three of them.
constexpr bool may_be_segments(std::uint32_t frames, std::uint32_t length, std::uint32_t overlap) {
  return length >= kLeastSegment && length < frames && overlap >= 1 && overlap <= length / 2;
}

/// Blending weight of the later of two segments, at position `shared` of their overlap.
float share_of_later(const SegmentLayout& layout, int shared);

/// Blends the samples of two segments. Every operation is rounded to a float, so that all decoders
/// give the same bits.
float blended(float earlier, float later, float share_of_later);

}  // namespace mocapress::runtime
