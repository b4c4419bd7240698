// SPDX-License-Identifier: MIT
#include "core/motion/skin_points.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <random>

#include "core/base/error.h"
#include "core/metrics/distortion.h"
#include "core/select/error_model.h"
#include "tests/support/test_motion.h"

namespace mocapress::skin_points_test {
namespace {

using Eigen::Vector3d;

/// A strip from x = 0 to 300. One third of its length has nine tenths of the triangles. Joint 0
/// carries one end and joint 1 the other; in the middle they share.
Skin strip() {
  Skin skin;
  skin.bones = {{0, Eigen::Affine3d::Identity()},
                {1, Eigen::Affine3d(Eigen::Translation3d(-150, 0, 0))}};
  const auto add = [&](float x) {
    const float to_second = std::clamp((x - 120) / 60, 0.0F, 1.0F);
    for (const float y : {-10.0F, 10.0F})
      skin.vertices.push_back(
          {{x, y, 5}, {0, 0, 1}, kPlainSkin, {{0, 1}, {1 - to_second, to_second}}});
  };
  for (int i = 0; i <= 90; ++i) add(static_cast<float>(i) * 100 / 90);
  for (int i = 1; i <= 10; ++i) add(100 + 20 * static_cast<float>(i));
  for (std::uint32_t v = 0; v + 3 < skin.vertices.size(); v += 2) {
    skin.triangles.push_back({v, v + 2, v + 1});
    skin.triangles.push_back({v + 1, v + 2, v + 3});
  }
  return skin;
}

Skeleton two_joints() {
  Skeleton skeleton;
  Joint first;
  first.name = "first";
  first.channels = {ChannelKind::TranslationX, ChannelKind::RotationZ, ChannelKind::RotationX};
  skeleton.add(first);
  Joint second;
  second.name = "second";
  second.parent = 0;
  second.offset = {150, 0, 0};
  second.channels = {ChannelKind::RotationZ, ChannelKind::RotationY};
  skeleton.add(second);
  return skeleton;
}

Vector3d place(const SkinPoint& point, const Pose& pose) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& [joint, in_joint, weight] : point)
    sum += weight * pose.to_world(joint, in_joint);
  return sum;
}

Motion dressed_motion(int frames) {
  Motion motion = test::smooth_motion(frames);
  const int joints = motion.skeleton.joint_count();
  std::mt19937 random(3);
  const auto number = [&](double most) {
    return std::uniform_real_distribution(-most, most)(random);
  };
  SkinPoints points;
  for (int i = 0; i < 60; ++i) {
    const double weight = i % 3 == 0 ? 1 : 0.5 + std::abs(number(0.5));
    SkinPoint point{{i % joints, {number(9), number(9), number(9)}, weight}};
    if (weight < 1)
      point.push_back({(i + 1) % joints, {number(9), number(9), number(9)}, 1 - weight});
    points.push_back(point);
  }
  motion.skeleton.set_skin(std::make_shared<const SkinPoints>(points));
  return motion;
}

TEST(SkinPoints, LieEvenlyOverTheMeshHoweverItIsCut) {
  const Skeleton skeleton = two_joints();
  const Pose rest = rest_pose(skeleton);
  const SkinPoints points = points_on(strip());
  ASSERT_GE(points.size(), 500u);
  for (int part = 0; part < 10; ++part) {
    const auto inside = std::count_if(points.begin(), points.end(), [&](const SkinPoint& point) {
      const double x = place(point, rest).x();
      return x >= 30 * part && x < 30 * (part + 1);
    });
    EXPECT_NEAR(static_cast<double>(inside) / static_cast<double>(points.size()), 0.1, 0.02);
  }
}

TEST(SkinPoints, StayOnTheMeshAsEnginesBendIt) {
  const Skin skin = strip();
  const Skeleton skeleton = two_joints();
  Pose pose;
  compute_pose(skeleton, Eigen::RowVectorXd{{20, 0.4, -0.3, 1.1, 0.5}}, pose);
  const std::vector<Vector3d> bent = skinned_positions(skin, pose);
  for (const SkinPoint& point : points_on(skin)) {
    double sum = 0;
    for (const auto& share : point) sum += share.weight;
    EXPECT_NEAR(sum, 1, 1e-6);
    // A point lies in a triangle if its coordinates there are from 0 to 1 and its height is 0.
    const Vector3d at = place(point, pose);
    const bool lies_on_it =
        std::any_of(skin.triangles.begin(), skin.triangles.end(), [&](const auto& triangle) {
          const Vector3d& a = bent[triangle[0]];
          Eigen::Matrix3d frame;
          frame << bent[triangle[1]] - a, bent[triangle[2]] - a,
              (bent[triangle[1]] - a).cross(bent[triangle[2]] - a).normalized();
          const Vector3d found = frame.inverse() * (at - a);
          return found.x() > -1e-4 && found.y() > -1e-4 && found.x() + found.y() < 1 + 1e-4 &&
                 std::abs(found.z()) < 1e-4;
        });
    EXPECT_TRUE(lies_on_it) << at.transpose();
  }
}

TEST(SkinPoints, AMeshWithoutAreaHasNone) {
  Skin skin = strip();
  for (Skin::Vertex& vertex : skin.vertices) vertex.in_bind.setZero();
  EXPECT_TRUE(points_on(skin).empty());
  EXPECT_TRUE(points_on(Skin()).empty());
}

TEST(SkinPoints, AreMovedAsTheirShares) {
  const Motion motion = dressed_motion(20);
  const SkinPoints& points = *motion.skeleton.skin();
  const Clip other = test::smooth_motion(20, 2).clip;
  double sum = 0;
  double most = 0;
  Pose a, b;
  for (int t = 0; t < 20; ++t) {
    compute_pose(motion.skeleton, motion.clip.channels.row(t), a);
    compute_pose(motion.skeleton, other.channels.row(t), b);
    for (const SkinPoint& point : points) {
      const double distance = (place(point, a) - place(point, b)).norm();
      sum += distance * distance;
      most = std::max(most, distance);
    }
  }
  const Distortion found = measure(motion.skeleton, motion.clip, other);
  ASSERT_TRUE(found.skin);
  EXPECT_NEAR(found.skin->rms, std::sqrt(sum / (20.0 * 60)), 1e-9);
  EXPECT_NEAR(found.skin->max.cm, most, 1e-9);
  EXPECT_NEAR(found.eps(Weighting::Skin), found.skin->rms, 0);
  EXPECT_NEAR(found.skin_of_joints.col(1).maxCoeff(), most, 1e-9);
  EXPECT_NEAR(
      exact_eps(motion.skeleton, body_tracks(motion.skeleton, motion.clip), other, Weighting::Skin),
      found.skin->rms, 1e-9);
}

/// The modelled error over the exact one, for small errors.
double modelled_over_exact(const Motion& motion) {
  const ErrorModel model(motion.skeleton, motion.clip, Weighting::Skin);
  ErrorState state(model);
  Clip other = motion.clip;
  std::mt19937 random(5);
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    const Eigen::VectorXd delta = Eigen::VectorXd::NullaryExpr(
        motion.clip.frames(), [&] { return std::uniform_real_distribution(-1e-4, 1e-4)(random); });
    other.channels.col(c) += delta;
    state.add(c, delta);
  }
  return std::sqrt(state.squared_eps()) / measure(motion.skeleton, motion.clip, other).skin->rms;
}

TEST(SkinPoints, CarriedByOneJointEachHaveAnExactErrorModel) {
  Motion motion = dressed_motion(30);
  SkinPoints rigid = *motion.skeleton.skin();
  for (SkinPoint& point : rigid) {
    point.resize(1);
    point.front().weight = 1;
  }
  motion.skeleton.set_skin(std::make_shared<const SkinPoints>(rigid));
  EXPECT_NEAR(modelled_over_exact(motion), 1, 1e-3);
}

TEST(SkinPoints, CarriedByTwoJointsAreRatedNoLowerThanTheyAre) {
  const double ratio = modelled_over_exact(dressed_motion(30));
  EXPECT_GE(ratio, 1 - 1e-3);
  EXPECT_LT(ratio, 1.5);
}

TEST(SkinPoints, AreNotMeasuredWhereThereAreNone) {
  const Motion motion = test::smooth_motion(4);
  EXPECT_FALSE(measure(motion.skeleton, motion.clip, motion.clip).skin);
  EXPECT_THROW(measured_points(motion.skeleton, Weighting::Skin), Error);
}

}  // namespace
}  // namespace mocapress::skin_points_test
