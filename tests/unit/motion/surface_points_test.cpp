// SPDX-License-Identifier: MIT
#include "core/motion/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/codec/encode/encoder.h"
#include "core/motion/skin_points.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using Eigen::Vector3d;

/// A cube of 2 * `half` cm around `centre`, carried by one joint.
void add_cube(Skin& skin, int joint, const Vector3d& centre, double half) {
  const auto bone = static_cast<std::uint8_t>(skin.bones.size());
  skin.bones.push_back({joint, Eigen::Affine3d::Identity()});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-half, half}) {
      const auto first = static_cast<std::uint32_t>(skin.vertices.size());
      for (const auto& [u, v] :
           {std::array{-half, -half}, {half, -half}, {-half, half}, {half, half}}) {
        Vector3d corner;
        corner(axis) = side;
        corner((axis + 1) % 3) = u;
        corner((axis + 2) % 3) = v;
        skin.vertices.push_back(
            {(centre + corner).cast<float>(), Eigen::Vector3f::UnitX(), kPlainSkin, {{bone}, {1}}});
      }
      skin.triangles.push_back({first, first + 1, first + 2});
      skin.triangles.push_back({first + 1, first + 3, first + 2});
    }
}

/// A thing without bones that turns on the spot.
Motion turning_thing() {
  Skeleton skeleton;
  Joint joint;
  joint.name = "thing";
  joint.channels = {ChannelKind::RotationX, ChannelKind::RotationY, ChannelKind::RotationZ};
  skeleton.add(joint);
  Clip clip{30, Eigen::MatrixXd(90, 3)};
  for (int t = 0; t < 90; ++t)
    clip.channels.row(t) << 0.7 * std::sin(t / 9.0), 0.4 * std::cos(t / 7.0), t / 60.0;
  return {skeleton, clip};
}

TEST(SurfacePoints, LieOnTheMeshOfAThingWithoutBones) {
  Motion motion = turning_thing();
  EXPECT_TRUE(far_meshes(motion.skeleton).empty());
  Skin skin;
  add_cube(skin, 0, {0, 0, 0}, 100);
  measure_on(&skin, motion.skeleton);
  const std::vector<FarMesh> far = far_meshes(motion.skeleton);
  ASSERT_EQ(far.size(), 1u);
  EXPECT_NEAR(far[0].mesh_cm, 100 * std::sqrt(5.0 / 3), 2);
  EXPECT_NEAR(far[0].body_cm, kShellRadius, 1e-9);
  const Encoding made = Encoder(std::move(motion))
                            .encode({.method = Method::ClosedLoop,
                                     .weighting = Weighting::Surface,
                                     .target = {Target::Kind::Error, 0.25}});
  EXPECT_LE(made.distortion.surface.rms, 0.25);
  EXPECT_NEAR(made.distortion.surface.rms, made.distortion.skin->rms, 1e-9);
  EXPECT_LT(made.distortion.skin->max.cm, 2);
}

TEST(SurfacePoints, ReachToTheEndOfAPropAndWeighAsTheHand) {
  Motion motion = test::smooth_motion(4);
  const MeasuredPoints bare = surface_points(motion.skeleton);
  const int hand = bare.points.back().joint;
  const auto weight_of = [&](const MeasuredPoints& measured) {
    double sum = 0;
    for (std::size_t p = 0; p < measured.points.size(); ++p)
      if (measured.points[p].joint == hand) sum += measured.weights(static_cast<Eigen::Index>(p));
    return sum;
  };
  Skin skin;
  add_cube(skin, hand, {0, 400, 0}, 10);
  measure_on(&skin, motion.skeleton);
  const MeasuredPoints with_prop = surface_points(motion.skeleton);
  EXPECT_NEAR(with_prop.weights.sum(), 1, 1e-12);
  EXPECT_NEAR(weight_of(with_prop), weight_of(bare), 1e-12);
  for (const Landmark& point : with_prop.points)
    if (point.joint == hand) {
      EXPECT_NEAR(point.in_joint.y(), 400, 20);
    }
  // The other joints keep their points.
  std::size_t same = 0;
  for (const Landmark& point : bare.points)
    same +=
        std::any_of(with_prop.points.begin(), with_prop.points.end(), [&](const Landmark& other) {
          return other.joint == point.joint && other.in_joint == point.in_joint;
        });
  EXPECT_EQ(same + 4, with_prop.points.size());
}

TEST(SurfacePoints, StayAroundTheBonesWhereTheMeshIsNear) {
  Motion motion = test::smooth_motion(4);
  const MeasuredPoints bare = surface_points(motion.skeleton);
  Skin skin;
  for (int j = 0; j < motion.skeleton.joint_count(); ++j) add_cube(skin, j, {0, 0, 0}, 4);
  measure_on(&skin, motion.skeleton);
  EXPECT_TRUE(far_meshes(motion.skeleton).empty());
  const MeasuredPoints dressed = surface_points(motion.skeleton);
  ASSERT_EQ(dressed.points.size(), bare.points.size());
  EXPECT_EQ(dressed.weights, bare.weights);
  for (std::size_t p = 0; p < bare.points.size(); ++p)
    EXPECT_EQ(dressed.points[p].in_joint, bare.points[p].in_joint);
}

}  // namespace
}  // namespace mocapress
