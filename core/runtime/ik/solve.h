// SPDX-License-Identifier: MIT
// Inverse kinematics. Based on: C. Welman, 1993 (cyclic coordinate descent), and S. R. Buss, 2004
// (damped least squares); see solve.cpp. FORMAT.md states both algorithms step by step, because
// every decoder must arrive at the same angles.
#pragma once

#include <cstdint>

#include "core/runtime/format/kinds.h"
#include "core/runtime/ik/limb.h"

namespace mocapress::runtime {

/// An effector within this distance of its target has reached it.
inline constexpr double kReachedCm = 0.01;

/// Largest numbers of iterations of the two solvers.
inline constexpr int kMostSweeps = 60;       // cyclic descent
inline constexpr int kMostNewtonSteps = 12;  // nearest pose

struct SolveOutcome {
  double miss_cm = 0;  // largest remaining distance between an effector and its target
  int iterations = 0;
};

/// Changes the limb's angles so that its effectors reach `targets`, or come as close as they can.
/// It starts from the angles of the frame. `targets` has one position per effector, in cm, in world
/// space. `most_iterations` may lower the format's limit, for speed.
SolveOutcome solve(Solver solver, Limb& limb, const Vector3* targets,
                   int most_iterations = kMostSweeps);

}  // namespace mocapress::runtime
