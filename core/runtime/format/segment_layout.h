// SPDX-License-Identifier: MIT
// How the frames of a long clip fall into segments that overlap: FORMAT.md, SEGS.
#pragma once

#include <algorithm>
#include <cstdint>

namespace mocapress::runtime {

inline constexpr std::uint32_t kLeastSegment =
    256;  // frames: bounds what a segment costs by itself

/// Segments of `length` frames, the last of no more, each sharing `overlap` frames with the next.
/// Where there is one only, its length is that of the clip and nothing is shared.
struct SegmentLayout {
  int frames = 0;  // of the clip
  int length = 0;
  int overlap = 0;

  static constexpr SegmentLayout whole(int frames) { return {frames, frames, 0}; }

  constexpr int hop() const { return length - overlap; }
  constexpr int count() const {
    return frames <= length ? 1 : 1 + (frames - length + hop() - 1) / hop();
  }
  constexpr int first(int segment) const { return segment * hop(); }
  constexpr int frames_of(int segment) const { return std::min(length, frames - first(segment)); }

  /// Frames of all segments together: those that two share count twice.
  constexpr std::int64_t coded_frames() const {
    return frames + static_cast<std::int64_t>(count() - 1) * overlap;
  }

  /// Frames in a row that come from the same segments.
  struct Stretch {
    int segment;  // the last of them
    int frames;   // how many from the one asked for
    int shared;   // how far into the frames shared with the segment before, from 0; -1: beyond
  };
  constexpr Stretch stretch_at(int frame) const {
    const int segment = hop() > 0 ? std::min(frame / hop(), count() - 1) : 0;
    const int into = frame - first(segment);
    if (segment > 0 && into < overlap) return {segment, overlap - into, into};
    const int next = segment + 1 < count() ? first(segment + 1) : frames;
    return {segment, next - frame, -1};
  }
};

/// Whether a file may have segments so: at least two, and no frame in three of them.
constexpr bool may_be_segments(std::uint32_t frames, std::uint32_t length, std::uint32_t overlap) {
  return length >= kLeastSegment && length < frames && overlap >= 1 && overlap <= length / 2;
}

/// The share of the later of two segments at a frame that both have, `shared` into them.
float share_of_later(const SegmentLayout& layout, int shared);

/// A sample of both, in floats whose every step is rounded.
float blended(float earlier, float later, float share_of_later);

}  // namespace mocapress::runtime
