// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/ik/limb.h"
#include "core/runtime/solve.h"

namespace mocapress {

/// The values are part of the file format.
enum class IkSolver : std::uint8_t {
  CyclicDescent = 1,  // the paper's: one joint after the other, over and over
  NearestPose = 2,    // what moves the limb least: two bones in closed form, else damped steps
};

/// "cyclic-descent", "nearest-pose".
std::string_view name(IkSolver solver);

struct IkOutcome {
  double miss_cm = 0;  // the largest distance left between an effector and its target
  int iterations = 0;
  bool reached = true;  // miss_cm is within kReachedCm
};

using runtime::kReachedCm;

/// Turns the limb's angles, starting from the frame's, so that its effectors come to `targets` (cm,
/// in the world, one for each). Bone lengths cannot change: only angles do. A target out of reach
/// is approached and reported. Requires targets.size() == limb.effectors().size().
IkOutcome solve(IkSolver solver, Limb& limb, std::span<const Eigen::Vector3d> targets);

}  // namespace mocapress
