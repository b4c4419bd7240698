// SPDX-License-Identifier: MIT
// Samples the pose of a cooked clip at an instant.
#pragma once

#include <algorithm>

#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// An instant of a request in frames; not finite if no double holds it.
inline double frame_of(const mcpr_cooked& clip, mcpr_time unit, double time) {
  return unit == MCPR_SECONDS ? time * clip.sample_rate : time;
}

PlaceInClip place_in_clip(const mcpr_cooked& clip, const mcpr_sample_request& request, double time);

/// A frame, or an instant between it and the next.
struct BetweenFrames {
  int before = 0;
  float share = 0;
};

/// Splits an instant of a clip with this many frames.
inline BetweenFrames between_frames(int frames, double frame) {
  const int before = std::min(static_cast<int>(frame), frames - 1);
  const float share = before + 1 < frames ? static_cast<float>(frame - before) : 0.0F;
  if (share < kAtFrame) return {before, 0};
  if (share > 1 - kAtFrame) return {before + 1, 0};
  return {before, share};
}

/// True if a cursor can cache what an instant needs: its frames lie in one segment, outside
/// overlaps. `stretch` is that of the first frame.
inline bool is_liftable(const SegmentLayout::Stretch& stretch, const BetweenFrames& instant) {
  return stretch.shared < 0 && (instant.share == 0 || stretch.frames > 1);
}

/// Number of joints in a request's output.
std::uint32_t sampled_joints(const mcpr_cooked& clip, const mcpr_sample_request& request);

/// Bytes of scratch memory that a request needs; 0: it does without.
std::size_t scratch_of(const mcpr_cooked& clip, const mcpr_sample_request& request);

/// No request needs more: columns of the largest clip, a list of all of its joints, others that
/// step, transforms of all.
inline constexpr std::size_t kMostScratchOfPose = std::size_t{192} << 10;

/// Writes all joints of the clip to `out`, or those of the request's list. `cursor` belongs to the
/// clip, or is null. The request has the scratch memory that it needs.
void sample(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
            const mcpr_sample_request& request, void* out, mcpr_cursor* cursor = nullptr);

}  // namespace mocapress::runtime
