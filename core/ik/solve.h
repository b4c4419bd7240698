// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/ik/correction_kind.h"
#include "core/ik/limb.h"
#include "core/motion/clip.h"
#include "core/runtime/ik/solve.h"

namespace mocapress {

struct IkOutcome {
  double miss_cm = 0;  // largest remaining distance between an effector and its target
  int iterations = 0;
  bool reached = true;  // miss_cm is within kReachedCm
};

using runtime::kReachedCm;

/// Turns the limb's angles, starting from the frame's, so that its effectors reach `targets` (cm,
/// world space, one for each). Bone lengths do not change. A target out of reach is approached and
/// reported. Requires targets.size() == limb.effectors().size().
IkOutcome solve(IkSolver solver, Limb& limb, std::span<const Eigen::Vector3d> targets);

/// The turns by which a solver answers small corrections of one limb's effectors.
struct LimbResponse {
  std::vector<Effector> effectors;
  std::vector<int> channels;  // angles that the solver may turn
  Eigen::MatrixXd turns;      // radians a cm: frames x 3 * effectors * channels
};

/// The response of each limb to corrections at each pose of a clip. Frames are solved in parallel.
std::vector<LimbResponse> limb_responses(const Skeleton& skeleton,
                                         const std::vector<Effector>& effectors, IkSolver solver,
                                         const Clip& clip);

}  // namespace mocapress
