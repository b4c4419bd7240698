// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/ik/ik_solver.h"
#include "core/ik/limb.h"
#include "core/runtime/solve.h"

namespace mocapress {

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
