// SPDX-License-Identifier: MIT
#include "core/baselines/quaternion.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/baselines/rivals.h"
#include "core/codec/methods/compression_method.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(QuaternionSignals, GiveEveryAngleBack) {
  const Motion motion = test::smooth_motion(300);
  const QuaternionSignals quaternions(motion.skeleton);
  const Clip clip = quaternions.clip_of(quaternions.of(motion.clip), 120);
  EXPECT_LT((clip.channels - motion.clip.channels).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(QuaternionSignals, AreThreeForTheRootAndFourForEachJointThatTurns) {
  EXPECT_EQ(QuaternionSignals(test::small_skeleton()).count(), 3 + 8 * 4);
}

TEST(QuaternionSignals, DoNotJumpToTheOtherQuaternionOfARotation) {
  Motion motion = test::smooth_motion(200);
  for (int t = 0; t < 200; ++t) motion.clip.channels(t, 4) = 0.1 * t;  // three whole turns
  const Eigen::MatrixXd signals = QuaternionSignals(motion.skeleton).of(motion.clip);
  const Eigen::MatrixXd steps = (signals.bottomRows(199) - signals.topRows(199)).rightCols(32);
  EXPECT_LT(steps.cwiseAbs().maxCoeff(), 0.2);
}

TEST(QuaternionSignals, TheirErrorModelAgreesWithExactDistortionForSmallErrors) {
  const Motion motion = test::smooth_motion(150);
  const QuaternionSignals quaternions(motion.skeleton);
  const Eigen::MatrixXd signals = quaternions.of(motion.clip);
  const ErrorModel model(motion.skeleton, motion.clip,
                         measured_points(motion.skeleton, Weighting::BoneEnds),
                         quaternions.moves(motion.clip, signals));
  // The model does not cover errors by which a quaternion of one or two axes leaves those axes.
  const int free_signals = 3 + 4 + 4;  // root and spine
  Random random(1);
  ErrorState state(model);
  Eigen::MatrixXd changed = signals;
  for (int s = 0; s < free_signals; ++s) {
    Eigen::VectorXd delta(150);
    for (double& value : delta) value = (s < 3 ? 0.2 : 0.002) * (random.unit() - 0.5);
    changed.col(s) += delta;
    state.add(s, delta);
  }
  const double exact =
      measure(motion.skeleton, motion.clip, quaternions.clip_of(changed, 120)).eps_bone_ends;
  EXPECT_NEAR(std::sqrt(state.squared_eps()) / exact, 1, 0.003);
}

TEST(Quaternion, TakesMoreThanAdaptedAnglesAtTheSameError) {
  const MethodEncoder encoder(test::smooth_motion(300));
  const EncodeSettings options{.weighting = Weighting::BoneEnds,
                               .target = {Target::Kind::Error, 0.5}};
  EXPECT_GT(
      encoder.compress(*find_compression_method("quaternion"), options).compressed.motion_bytes(),
      encoder.compress(*find_compression_method("annealed"), options).compressed.motion_bytes());
}

TEST(Quaternion, GoesThroughWholeTurnsWithoutAJump) {
  Motion motion = test::smooth_motion(240);
  for (int t = 0; t < 240; ++t) motion.clip.channels(t, 4) = 0.1 * t;  // the root's heading
  const auto coder = kQuaternion.analyse(motion, Weighting::BoneEnds);
  const Clip decoded =
      kQuaternion.decode(motion.skeleton, 120, 240, coder->encode(coder->most_detail() / 6));
  EXPECT_LT(measure(motion.skeleton, motion.clip, decoded).max.cm, 3);
}

TEST(Quaternion, LeavesOutSignalsThatMoveNoWeight) {
  // In joint-origins the hands' own turns move no point that counts.
  const Motion motion = test::smooth_motion(200);
  const auto bytes = [&](Weighting weighting) {
    return MethodEncoder(motion)
        .compress(*find_compression_method("quaternion"),
                  {.weighting = weighting, .target = {Target::Kind::Error, 0.3}})
        .compressed.motion_bytes();
  };
  EXPECT_LT(bytes(Weighting::JointOrigins), bytes(Weighting::BoneEnds));
}

}  // namespace
}  // namespace mocapress
