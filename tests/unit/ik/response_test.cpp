// SPDX-License-Identifier: MIT
#include "core/ik/response.h"
#include "core/feet/feet.h"

#include <gtest/gtest.h>

#include "core/ik/correction.h"
#include "core/motion/landmarks.h"
#include "resources/samples/generator/samples.h"

namespace mocapress {
namespace {

TEST(LimbResponses, TurnsMoveTheEffectorAsFarAsAsked) {
  const Motion walk = samples::walk_clip();
  Clip some{walk.clip.sample_rate_hz, walk.clip.channels.topRows(20)};
  const std::vector<Effector> feet = find_feet(walk.skeleton);
  const Eigen::MatrixXd before = effector_tracks(landmark_tracks(walk.skeleton, some), feet);
  for (const IkSolver solver : {IkSolver::CyclicDescent, IkSolver::NearestPose}) {
    const auto responses = limb_responses(walk.skeleton, feet, solver, some);
    ASSERT_EQ(responses.size(), 2u);
    constexpr double kMoved = 0.5;  // cm
    for (int axis = 0; axis < 3; ++axis) {
      Clip turned = some;
      for (const LimbResponse& limb : responses)
        for (std::size_t a = 0; a < limb.channels.size(); ++a)
          turned.channels.col(limb.channels[a]) +=
              kMoved * limb.turns.col(3 * static_cast<Eigen::Index>(a) + axis);
      Eigen::MatrixXd moved =
          effector_tracks(landmark_tracks(walk.skeleton, turned), feet) - before;
      for (Eigen::Index e = 0; e < 2; ++e) moved.col(3 * e + axis).array() -= kMoved;
      EXPECT_LT(moved.cwiseAbs().maxCoeff(), 0.06) << name(solver) << " along " << axis;
    }
  }
}

}  // namespace
}  // namespace mocapress
