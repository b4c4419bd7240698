// SPDX-License-Identifier: MIT
// The pose of a cooked clip at an instant.
#pragma once

#include "core/runtime/cooked_clip.h"
#include "core/runtime/pose_kernels.h"

namespace mocapress::runtime {

/// Null for a path that is not there.
const PoseKernels* poses_of(mcpr_path path);

/// Where an instant is: in the clip, or so far on the way from its last frame to its first.
struct PlaceInClip {
  double frame = 0;
  float across = 0;
};

PlaceInClip place_in_clip(const mcpr_cooked& clip, const mcpr_sample_request& request, double time);

/// Floats that a joint takes in a layout.
std::size_t values_of_joint(mcpr_layout layout);

/// `out`: of all joints of the clip or, where there is a list, of those in it.
/// `cursor`: of the clip, or null.
void sample(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
            const mcpr_sample_request& request, float* out, mcpr_cursor* cursor = nullptr);

}  // namespace mocapress::runtime
