// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/ik/solve.h"
#include "core/motion/clip.h"

namespace mocapress {

/// How a solver answers to small corrections of the effectors of one limb.
struct LimbResponse {
  std::vector<Effector> effectors;
  std::vector<int> channels;  // the angles it may turn
  Eigen::MatrixXd turns;      // radians a cm: frames x 3 * effectors * channels
};

/// For each limb, around the poses of a clip. Frames are solved in parallel.
std::vector<LimbResponse> limb_responses(const Skeleton& skeleton,
                                         const std::vector<Effector>& effectors, IkSolver solver,
                                         const Clip& clip);

}  // namespace mocapress
