// SPDX-License-Identifier: MIT
// Samples the pose of a cooked clip at an instant.
#pragma once

#include <algorithm>

#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// Converts an instant of a request to frames. The result is not finite if it is beyond the range
/// of doubles.
inline double frame_of(const mcpr_cooked& clip, mcpr_time unit, double time) {
  return unit == MCPR_SECONDS ? time * clip.sample_rate : time;
}

PlaceInClip place_in_clip(const mcpr_cooked& clip, const mcpr_sample_request& request, double time);

/// A frame (share 0), or an instant between a frame and the next.
struct BetweenFrames {
  int before = 0;
  float share = 0;
};

/// Splits an instant, in a clip with `frames` frames, into a frame and a share.
inline BetweenFrames between_frames(int frames, double frame) {
  const int before = std::min(static_cast<int>(frame), frames - 1);
  const float share = before + 1 < frames ? static_cast<float>(frame - before) : 0.0F;
  if (share < kAtFrame) return {before, 0};
  if (share > 1 - kAtFrame) return {before + 1, 0};
  return {before, share};
}

/// True if a cursor can cache the frames that an instant needs: they lie in one segment, outside
/// overlaps. `stretch` is the stretch of the first frame.
inline bool is_liftable(const SegmentLayout::Stretch& stretch, const BetweenFrames& instant) {
  return stretch.shared < 0 && (instant.share == 0 || stretch.frames > 1);
}

/// Number of joints in a request's output.
std::uint32_t sampled_joints(const mcpr_cooked& clip, const mcpr_sample_request& request);

/// Bytes of scratch memory that a request needs; 0: the stack suffices.
std::size_t scratch_of(const mcpr_cooked& clip, const mcpr_sample_request& request);

/// The most scratch memory that any request needs: for the columns of the largest clip, a list of
/// all of its joints, stepped joints, and the transforms of all joints.
inline constexpr std::size_t kMostScratchOfPose = std::size_t{192} << 10;

/// Samples the pose at an instant into `out`: all joints of the clip, or those that the request
/// lists. `cursor` belongs to the clip, or is null. The request has the scratch memory that
/// scratch_of() returns.
void sample(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
            const mcpr_sample_request& request, void* out, mcpr_cursor* cursor = nullptr);

}  // namespace mocapress::runtime
