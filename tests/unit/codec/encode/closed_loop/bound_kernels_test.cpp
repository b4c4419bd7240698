// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/bound_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace mocapress {
namespace {

constexpr double kSquaredBound = 16;  // cm^2

/// A point over some frames, and a channel that moves it.
struct Scene {
  explicit Scene(Eigen::Index frames)
      : error(draw(frames, 3, 1)),
        axis(draw(frames, 3, 1)),
        origin(draw(frames, 3, 50)),
        original(draw(frames, 3, 50)),
        along(frames, 3),
        across(frames, 3),
        squared(error.rowwise().squaredNorm()),
        angles(draw(frames, 1, 0.02)),
        sines(angles.array().sin()),
        less_cosines(1 - angles.array().cos()) {
    axis.rowwise().normalize();
    find_way_of_turn({axis.data(), frames}, {origin.data(), frames}, {original.data(), frames},
                     frames, turning());
  }

  Eigen::MatrixXd draw(Eigen::Index rows, Eigen::Index columns, double most) {
    return Eigen::MatrixXd::NullaryExpr(
        rows, columns, [&] { return std::uniform_real_distribution(-most, most)(random); });
  }

  MovedFrames turning() {
    const Eigen::Index frames = error.rows();
    return {
        {error.data(), frames}, {along.data(), frames}, {across.data(), frames}, squared.data()};
  }
  MovedFrames shifting() {
    MovedFrames moved = turning();
    moved.across = {};
    return moved;
  }
  MovingSteps turns() const { return {sines.data(), less_cosines.data(), sines.size()}; }

  /// The error once the point has turned about the axis by its angle.
  Eigen::Vector3d turned(Eigen::Index frame) const {
    const Eigen::Vector3d joint = origin.row(frame).transpose();
    const Eigen::Vector3d arm = (original + error).row(frame).transpose() - joint;
    const Eigen::AngleAxisd turn(angles(frame), axis.row(frame).transpose());
    return joint + turn * arm - original.row(frame).transpose();
  }

  std::mt19937 random{5};
  Eigen::MatrixXd error, axis, origin, original, along, across;
  Eigen::VectorXd squared, angles;
  Eigen::ArrayXd sines, less_cosines;
};

TEST(BoundKernels, TurnAPointAboutItsAxisInClipsOfAnyLength) {
  for (Eigen::Index frames = 1; frames <= 70; ++frames) {
    Scene scene(frames);
    const Scene before = scene;
    move_point(scene.turning(), scene.turns());
    for (Eigen::Index t = 0; t < frames; ++t) {
      EXPECT_LT((scene.error.row(t).transpose() - before.turned(t)).norm(), 1e-9);
      EXPECT_NEAR(scene.squared(t), before.turned(t).squaredNorm(), 1e-9);
    }
    // Along and across have turned with it: another turn goes on from there.
    move_point(scene.turning(), scene.turns());
    for (Eigen::Index t = 0; t < frames; ++t) {
      Scene twice = before;
      twice.angles *= 2;
      EXPECT_LT((scene.error.row(t).transpose() - twice.turned(t)).norm(), 1e-9);
    }
  }
}

TEST(BoundKernels, ShiftAPointThatTranslates) {
  Scene scene(21);
  const Eigen::MatrixXd expected = scene.error + scene.angles.asDiagonal() * scene.along;
  move_point(scene.shifting(), {scene.angles.data(), nullptr, 21});
  EXPECT_LT((scene.error - expected).norm(), 1e-12);
}

TEST(BoundKernels, SeeTheOneFrameThatGoesBeyondTheBoundWhereverItIs) {
  for (const Eigen::Index frames : {1, 2, 3, 7, 64, 67, 131})
    for (Eigen::Index beyond = 0; beyond < frames; ++beyond) {
      Scene scene(frames);
      scene.sines.setZero();
      scene.less_cosines.setZero();
      const Eigen::VectorXd bound = Eigen::VectorXd::Constant(frames, kSquaredBound);
      ASSERT_FALSE(goes_beyond(scene.turning(), scene.turns(), bound.data()));
      scene.sines(beyond) = 10 / scene.along.row(beyond).norm();
      EXPECT_TRUE(goes_beyond(scene.turning(), scene.turns(), bound.data())) << beyond;
      EXPECT_TRUE(
          goes_beyond(scene.shifting(), {scene.sines.data(), nullptr, frames}, bound.data()));
      scene.squared(beyond) = 1e6;  // it comes nearer
      EXPECT_FALSE(goes_beyond(scene.turning(), scene.turns(), bound.data())) << beyond;
    }
}

}  // namespace
}  // namespace mocapress
