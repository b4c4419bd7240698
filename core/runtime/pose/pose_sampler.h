// SPDX-License-Identifier: MIT
// The pose of a cooked clip at an instant.
#pragma once

#include <algorithm>

#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// Null for a path that is not there.
const PoseKernels* poses_of(mcpr_path path);

/// Where an instant is: in the clip, or so far on the way from its last frame to its first.
struct PlaceInClip {
  double frame = 0;
  float across = 0;
};

PlaceInClip place_in_clip(const mcpr_cooked& clip, const mcpr_sample_request& request, double time);

/// At a frame, or on the way to the next.
struct BetweenFrames {
  int before = 0;
  float share = 0;
};

/// Frames from one within which an instant is that frame: seconds times a rate are rounded, and a
/// frame costs less than what is between two, most of all in play at half the rate.
inline constexpr float kAtFrame = 0x1p-16F;

/// Of a clip of so many frames.
inline BetweenFrames between_frames(int frames, double frame) {
  const int before = std::min(static_cast<int>(frame), frames - 1);
  const float share = before + 1 < frames ? static_cast<float>(frame - before) : 0.0F;
  if (share < kAtFrame) return {before, 0};
  if (share > 1 - kAtFrame) return {before + 1, 0};
  return {before, share};
}

/// Whether a cursor may keep what an instant needs: where the stretch is that its first frame is
/// in, not in two segments, nor in one and the next.
inline bool is_liftable(const SegmentLayout::Stretch& stretch, const BetweenFrames& instant) {
  return stretch.shared < 0 && (instant.share == 0 || stretch.frames > 1);
}

/// Floats that a joint takes in a layout.
std::size_t values_of_joint(mcpr_layout layout);

/// `out`: of all joints of the clip or, where there is a list, of those in it.
/// `cursor`: of the clip, or null.
void sample(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
            const mcpr_sample_request& request, float* out, mcpr_cursor* cursor = nullptr);

}  // namespace mocapress::runtime
