// SPDX-License-Identifier: MIT
#include "core/ik/solve.h"

#include <array>
#include <cassert>

namespace mocapress {

std::string_view name(IkSolver solver) {
  return solver == IkSolver::CyclicDescent ? "cyclic-descent" : "nearest-pose";
}

IkOutcome solve(IkSolver solver, Limb& limb, std::span<const Eigen::Vector3d> targets) {
  assert(targets.size() == limb.effectors().size());
  std::array<runtime::Vector3, runtime::kMostEffectorsOfLimb> points;
  for (std::size_t e = 0; e < targets.size(); ++e)
    points[e] = {{targets[e].x(), targets[e].y(), targets[e].z()}};
  const runtime::SolveOutcome outcome =
      runtime::solve(static_cast<runtime::Solver>(solver), limb.of_decoder(), points.data());
  return {outcome.miss_cm, outcome.iterations, outcome.miss_cm <= kReachedCm};
}

}  // namespace mocapress
