// SPDX-License-Identifier: MIT
// Based on: C. Welman, 1993 (cyclic coordinate descent), and S. R. Buss, 2004 (damped least
// squares); see solve.cpp. FORMAT.md has both step by step, for every decoder must come to the same
// angles.
#pragma once

#include <cstdint>

#include "core/runtime/format/kinds.h"
#include "core/runtime/ik/limb.h"

namespace mocapress::runtime {

/// An effector as near to its target as this is there.
inline constexpr double kReachedCm = 0.01;

/// The iterations after which the format's solvers give up.
inline constexpr int kMostSweeps = 60;       // of cyclic descent
inline constexpr int kMostNewtonSteps = 12;  // of the nearest pose

struct SolveOutcome {
  double miss_cm = 0;  // the largest distance left between an effector and its target
  int iterations = 0;
};

/// Turns the limb's angles, starting from the frame's, so that its effectors come to `targets` (cm,
/// in the world, one for each). A target out of reach is approached. No more than
/// `most_iterations`, which only a caller in haste sets below the format's.
SolveOutcome solve(Solver solver, Limb& limb, const Vector3* targets,
                   int most_iterations = kMostSweeps);

}  // namespace mocapress::runtime
