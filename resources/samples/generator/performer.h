// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "core/motion/clip.h"
#include "resources/samples/generator/foot_plan.h"
#include "resources/samples/generator/posture.h"

namespace mocapress::samples {

inline constexpr double kSampleRate = 120;  // Hz
inline constexpr double kGravity = 981;     // cm/s^2

/// The point that `centre` moves.
enum class Centre { Root, Mass };

/// The wanted movement of the figure, before it becomes angles.
struct Choreography {
  double seconds;
  FootPlan left;
  FootPlan right;
  Centre centre_of;
  std::function<Eigen::Vector3d(double)> centre;  // cm in the world, at a time (s)
  std::function<Posture(double)> posture;         // pelvis, trunk and arms; at a time (s)

  const FootPlan& foot(Side side) const { return side == Side::Left ? left : right; }
};

/// The choreography as a clip, with natural unrest and sensor noise of that seed everywhere; the
/// feet still stand. Values are rounded to 1e-4 (degrees, and units of length of an .asf), so that
/// the last bit of a cosine, which machines disagree about, does not show.
Motion perform(const Choreography& choreography, std::uint64_t seed);

}  // namespace mocapress::samples
