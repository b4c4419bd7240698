// SPDX-License-Identifier: MIT
#include "core/ik/solve.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/random.h"
#include "core/feet/feet.h"
#include "core/ik/correction.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::solve_test {
namespace {

constexpr IkSolver kSolvers[] = {IkSolver::CyclicDescent, IkSolver::NearestPose};
constexpr double kThigh = 42;  // cm
constexpr double kShin = 41;

/// A hip of 3 axes, a hinge knee, an ankle of 2 and the ball of the foot, hanging from a root.
Skeleton leg() {
  using enum ChannelKind;
  Skeleton skeleton;
  skeleton.add({.name = "root", .channels = {TranslationX, TranslationY, TranslationZ, RotationY}});
  skeleton.add({.name = "pelvis", .parent = 0, .offset = {9, -5, 0}});
  skeleton.add({.name = "thigh",
                .parent = 1,
                .offset = {2, 0, 0},
                .joint_from_axes = axis_rotation(2, 0.3),
                .channels = {RotationZ, RotationY, RotationX}});
  skeleton.add({.name = "shin", .parent = 2, .offset = {0, -kThigh, 0}, .channels = {RotationX}});
  skeleton.add(
      {.name = "foot", .parent = 3, .offset = {0, -kShin, 0}, .channels = {RotationZ, RotationX}});
  skeleton.add({.name = "ball", .parent = 4, .offset = {0, -6, 13}});
  return skeleton;
}

Eigen::RowVectorXd bent_frame(double knee = 0.5) {
  Eigen::RowVectorXd frame(10);
  frame << 3, 95, -2, 0.4, 0.05, -0.1, -0.3, knee, 0.05, 0.2;
  return frame;
}

Limb limb_at(const Skeleton& skeleton, const Eigen::RowVectorXd& frame) {
  Limb limb(skeleton, {effector_at(skeleton, 5)});
  limb.set_frame(frame);
  return limb;
}

Eigen::RowVectorXd with_angles(Eigen::RowVectorXd frame, const Limb& limb) {
  for (int a = 0; a < limb.angle_count(); ++a) frame(limb.channel(a)) = limb.angles()(a);
  return frame;
}

TEST(Limb, AgreesWithForwardKinematicsOfTheWholeSkeleton) {
  const Skeleton skeleton = leg();
  const Limb limb = limb_at(skeleton, bent_frame());
  Pose pose;
  compute_pose(skeleton, bent_frame(), pose);
  EXPECT_TRUE(limb.position(0).isApprox(pose.origin[5], 1e-12));
}

TEST(Limb, VelocityIsTheDerivativeOfThePosition) {
  const Skeleton skeleton = leg();
  Limb limb = limb_at(skeleton, bent_frame());
  for (int a = 0; a < limb.angle_count(); ++a) {
    const Eigen::Vector3d velocity = limb.velocity(0, a);
    constexpr double kStep = 1e-6;
    const Eigen::Vector3d before = limb.position(0);
    limb.turn(a, kStep);
    EXPECT_TRUE(((limb.position(0) - before) / kStep).isApprox(velocity, 1e-4));
    limb.turn(a, -kStep);
  }
}

TEST(Solve, ReachesNearbyTargetsAndForwardKinematicsAgrees) {
  const Skeleton skeleton = leg();
  Random random(1);
  for (const IkSolver solver : kSolvers)
    for (int round = 0; round < 200; ++round) {
      Limb limb = limb_at(skeleton, bent_frame());
      const Eigen::Vector3d way(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
      const Eigen::Vector3d target = limb.position(0) + 6 * way;
      const IkOutcome outcome = solve(solver, limb, {&target, 1});
      EXPECT_TRUE(outcome.reached) << name(solver) << " missed by " << outcome.miss_cm;
      Pose pose;
      compute_pose(skeleton, with_angles(bent_frame(), limb), pose);
      EXPECT_LE((pose.origin[5] - target).norm(), kReachedCm + 1e-9);
      EXPECT_NEAR((pose.origin[3] - pose.origin[2]).norm(), kThigh, 1e-9);
      EXPECT_NEAR((pose.origin[4] - pose.origin[3]).norm(), kShin, 1e-9);
    }
}

TEST(Solve, LeavesAFrameAloneThatIsRightAlready) {
  const Skeleton skeleton = leg();
  for (const IkSolver solver : kSolvers) {
    Limb limb = limb_at(skeleton, bent_frame());
    const Eigen::VectorXd before = limb.angles();
    const Eigen::Vector3d target = limb.position(0);
    EXPECT_EQ(solve(solver, limb, {&target, 1}).iterations, 0);
    EXPECT_EQ(limb.angles(), before);
  }
}

TEST(Solve, SaysWhenATargetIsOutOfReachAndComesNear) {
  const Skeleton skeleton = leg();
  for (const IkSolver solver : kSolvers) {
    Limb limb = limb_at(skeleton, bent_frame());
    const Eigen::Vector3d far = limb.position(0) + Eigen::Vector3d(0, -60, 0);
    const double before = (limb.position(0) - far).norm();
    const IkOutcome outcome = solve(solver, limb, {&far, 1});
    EXPECT_FALSE(outcome.reached);
    EXPECT_GT(outcome.miss_cm, kReachedCm);
    EXPECT_LT((limb.position(0) - far).norm(), before);
    EXPECT_TRUE(limb.angles().allFinite());
  }
}

TEST(Solve, NearestPoseTurnsLessThanCyclicDescent) {
  const Skeleton skeleton = leg();
  double turned[2] = {};
  for (std::size_t s = 0; s < 2; ++s) {
    Limb limb = limb_at(skeleton, bent_frame());
    const Eigen::VectorXd before = limb.angles();
    const Eigen::Vector3d target = limb.position(0) + Eigen::Vector3d(2, 1, 3);
    solve(kSolvers[s], limb, {&target, 1});
    turned[s] = (limb.angles() - before).norm();
  }
  EXPECT_LT(turned[1], turned[0]);
}

TEST(Solve, NearestPoseChangesSmoothlyWithItsTargetEvenWithTheLegNearlyStraight) {
  const Skeleton skeleton = leg();
  for (const double knee : {0.5, 0.1, 0.03}) {
    double last = knee;
    for (int step = 0; step <= 200; ++step) {
      Limb limb = limb_at(skeleton, bent_frame(knee));
      // A target that wanders up and down by half a centimetre, 0.005 cm a step.
      const Eigen::Vector3d target =
          limb.position(0) + Eigen::Vector3d(0, 0.5 * std::sin(step * 0.01), 0);
      solve(IkSolver::NearestPose, limb, {&target, 1});
      EXPECT_LT(std::abs(limb.angles()(3) - last), 0.02) << "knee " << knee << " step " << step;
      last = limb.angles()(3);
    }
  }
}

/// The ankle, which a ball joint and a hinge carry.
Limb two_bones(const Skeleton& skeleton, const Eigen::RowVectorXd& frame) {
  Limb limb(skeleton, {effector_at(skeleton, 4)});
  limb.set_frame(frame);
  return limb;
}

TEST(TwoBones, AreReachedExactlyInOneStep) {
  const Skeleton skeleton = leg();
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    Limb limb = two_bones(skeleton, bent_frame(0.7 + 0.005 * round));
    ASSERT_TRUE(limb.is_two_bones());
    const auto offset = [&] { return 4 * random.unit() - 2; };
    const Eigen::Vector3d targets[] = {limb.position(0) +
                                       Eigen::Vector3d(offset(), offset(), offset())};
    const IkOutcome outcome = solve(IkSolver::NearestPose, limb, targets);
    EXPECT_LT(outcome.miss_cm, 1e-9);
    EXPECT_EQ(outcome.iterations, 1);
    Pose pose;
    compute_pose(skeleton, with_angles(bent_frame(0.7 + 0.005 * round), limb), pose);
    EXPECT_LT((pose.origin[4] - targets[0]).norm(), 1e-9);
  }
}

TEST(TwoBones, DoNotJerkAKneeThatIsAlmostStraight) {
  const Skeleton skeleton = leg();
  for (double knee = 0.0; knee < 0.2; knee += 0.01) {
    Limb limb = two_bones(skeleton, bent_frame(knee));
    const Eigen::Vector3d hip = limb.center(0);
    // A centimetre nearer to the hip, along the leg.
    const Eigen::Vector3d targets[] = {limb.position(0) - (limb.position(0) - hip).normalized()};
    solve(IkSolver::NearestPose, limb, targets);
    EXPECT_LT(std::abs(limb.angles()(3) - knee), 0.36) << knee;
  }
}

TEST(TwoBones, AreNoLimbWithAnAnkleThatTurnsOrTwoEffectors) {
  const Skeleton skeleton = leg();
  EXPECT_FALSE(limb_at(skeleton, bent_frame()).is_two_bones());
  EXPECT_FALSE(Limb(skeleton, {effector_at(skeleton, 4), effector_at(skeleton, 3)}).is_two_bones());
}

TEST(Solve, HoldsSeveralEffectorsOfOneLimbAtOnce) {
  const Skeleton skeleton = leg();
  for (const IkSolver solver : kSolvers) {
    Limb limb(skeleton, {effector_at(skeleton, 4), effector_at(skeleton, 5)});
    limb.set_frame(bent_frame());
    // The effectors' positions after a small turn of every angle, which can be reached together.
    const Eigen::VectorXd turn = Eigen::VectorXd::Constant(limb.angle_count(), 0.03);
    limb.turn(turn);
    const Eigen::Vector3d targets[] = {limb.position(0), limb.position(1)};
    limb.turn(-turn);
    EXPECT_LT(solve(solver, limb, targets).miss_cm, 0.1) << name(solver);
  }
}

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
}  // namespace mocapress::solve_test
