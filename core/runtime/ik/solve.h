// SPDX-License-Identifier: MIT
// Inverse kinematics. Based on: C. Welman, 1993 (cyclic coordinate descent), and S. R. Buss, 2004
// (damped least squares); see solve.cpp. FORMAT.md states both algorithms step by step, because
// every decoder must arrive at the same angles.
#pragma once

#include <cstdint>

#include "core/runtime/format/kinds.h"
#include "core/runtime/ik/limb.h"

namespace mocapress::runtime {

/// Distance at which an effector counts as having reached its target.
inline constexpr double kReachedCm = 0.01;

/// Iteration limits of the format's solvers.
inline constexpr int kMostSweeps = 60;       // cyclic descent
inline constexpr int kMostNewtonSteps = 12;  // nearest pose

struct SolveOutcome {
  double miss_cm = 0;  // largest remaining distance between an effector and its target
  int iterations = 0;
};

/// Changes the limb's angles, starting from the frame's, so that its effectors reach `targets` (cm,
/// in world space, one for each). Comes as close as it can to a target out of reach.
/// `most_iterations` may lower the format's limit, for a caller in a hurry.
SolveOutcome solve(Solver solver, Limb& limb, const Vector3* targets,
                   int most_iterations = kMostSweeps);

}  // namespace mocapress::runtime
