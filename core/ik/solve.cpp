// SPDX-License-Identifier: MIT
#include "core/ik/solve.h"

#include <array>
#include <cassert>

#include "core/base/parallel.h"

namespace mocapress {

std::string_view name(IkSolver solver) {
  return solver == IkSolver::CyclicDescent ? "cyclic-descent" : "nearest-pose";
}

std::string_view name(CorrectAt at) {
  return at == CorrectAt::EveryFrame ? "every-frame" : "contacts";
}

IkOutcome solve(IkSolver solver, Limb& limb, std::span<const Eigen::Vector3d> targets) {
  assert(targets.size() == limb.effectors().size());
  std::array<runtime::Vector3, runtime::kMostEffectorsOfLimb> points;
  for (std::size_t e = 0; e < targets.size(); ++e)
    points[e] = {{targets[e].x(), targets[e].y(), targets[e].z()}};
  const runtime::SolveOutcome outcome = runtime::solve(solver, limb.of_decoder(), points.data());
  return {outcome.miss_cm, outcome.iterations, outcome.miss_cm <= kReachedCm};
}

namespace {

/// Fills one frame's row of `turns`: moves each effector a little along each axis and solves for
/// that.
void try_frame(IkSolver solver, Limb& limb, const FrameRow& frame, Eigen::MatrixXd& turns, int t) {
  constexpr double kTried = 1;  // cm: far more than a solver's miss
  const auto effectors = limb.effectors().size();
  const auto rows = static_cast<Eigen::Index>(3 * effectors);
  std::vector<Eigen::Vector3d> targets(effectors);
  for (Eigen::Index r = 0; r < rows; ++r) {
    limb.set_frame(frame);
    const Eigen::VectorXd before = limb.angles();
    for (std::size_t e = 0; e < effectors; ++e) targets[e] = limb.position(static_cast<int>(e));
    targets[r / 3](r % 3) += kTried;
    solve(solver, limb, targets);
    for (Eigen::Index a = 0; a < limb.angle_count(); ++a)
      turns(t, rows * a + r) = (limb.angles()(a) - before(a)) / kTried;
  }
}

}  // namespace

std::vector<LimbResponse> limb_responses(const Skeleton& skeleton,
                                         const std::vector<Effector>& effectors, IkSolver solver,
                                         const Clip& clip) {
  std::vector<LimbResponse> responses;
  for (const Limb& limb : limbs_of(skeleton, effectors)) {
    LimbResponse response{.effectors = limb.effectors(), .channels = {}, .turns = {}};
    for (int a = 0; a < limb.angle_count(); ++a) response.channels.push_back(limb.channel(a));
    response.turns.resize(clip.frames(),
                          3 * std::ssize(response.effectors) * std::ssize(response.channels));
    parallel_ranges(0, clip.frames(), 64, [&](int first, int end) {
      Limb own(skeleton, limb.effectors());  // one for each thread
      for (int t = first; t < end; ++t)
        try_frame(solver, own, clip.channels.row(t), response.turns, t);
    });
    responses.push_back(std::move(response));
  }
  return responses;
}

}  // namespace mocapress
