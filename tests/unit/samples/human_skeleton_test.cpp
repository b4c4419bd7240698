// SPDX-License-Identifier: MIT
#include "resources/samples/generator/human_skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/landmarks.h"

namespace mocapress::samples {
namespace {

Eigen::MatrixXd rest_landmarks(const Skeleton& skeleton) {
  const Clip rest{120, Eigen::MatrixXd::Zero(1, skeleton.channel_count())};
  return landmark_tracks(skeleton, rest).reshaped(3, landmarks(skeleton).size());
}

TEST(HumanSkeleton, Has62DegreesOfFreedom) {
  EXPECT_EQ(human_skeleton().channel_count(), 62);
}

TEST(HumanSkeleton, MeasuresItsStatureFromSoleToCrown) {
  const Skeleton skeleton = human_skeleton();
  const double ankle = rest_landmarks(skeleton)(1, skeleton.find("lfoot"));
  const double crown = rest_landmarks(skeleton).row(1).maxCoeff();
  EXPECT_NEAR(crown - (ankle - kAnkleHeight), kStature, 0.5);
}

TEST(HumanSkeleton, IsSymmetric) {
  const Skeleton skeleton = human_skeleton();
  const Eigen::MatrixXd rest = rest_landmarks(skeleton);
  int pairs = 0;
  for (int left = 0; left < skeleton.joint_count(); ++left) {
    const std::string& name = skeleton.joint(left).name;
    const int right = skeleton.find("r" + name.substr(1));
    if (name[0] != 'l' || right < 0) continue;
    ++pairs;
    EXPECT_TRUE(rest.col(left).isApprox(mirrored_offset(Side::Right, rest.col(right)), 1e-12))
        << name;
  }
  EXPECT_EQ(pairs, 12);
}

}  // namespace
}  // namespace mocapress::samples
