// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_transform.h"

#include <gtest/gtest.h>

#include <numbers>

namespace mocapress::fbx_transform_test {
namespace {

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

Affine3d affine(const LocalTransform& local) {
  Affine3d transform = Affine3d::Identity();
  transform.translate(local.translation).rotate(local.rotation).scale(local.scale);
  return transform;
}

Affine3d moved(const Vector3d& by) {
  return Affine3d(Eigen::Translation3d(by));
}

TEST(FbxTransform, MultipliesItsPartsInTheOrderOfTheFormat) {
  FbxTransform t;
  t.translation = {1, 2, 3};
  t.rotation = {10, 20, 30};
  t.scaling = {2, 0.5, 3};
  t.pre_rotation = {40, 50, 60};
  t.post_rotation = {-15, 25, 35};
  t.rotation_offset = {4, 5, 6};
  t.rotation_pivot = {7, 8, 9};
  t.scaling_offset = {-1, -2, 3};
  t.scaling_pivot = {3, -4, 5};
  const Affine3d expected =
      moved(t.translation) * moved(t.rotation_offset) * moved(t.rotation_pivot) *
      fbx_rotation(t.pre_rotation) * fbx_rotation(t.rotation) *
      fbx_rotation(t.post_rotation).inverse() * moved(-t.rotation_pivot) * moved(t.scaling_offset) *
      moved(t.scaling_pivot) * Eigen::Scaling(t.scaling) * moved(-t.scaling_pivot);
  EXPECT_LT((affine(t.local()).matrix() - expected.matrix()).norm(), 1e-12);
}

TEST(FbxTransform, TurnsInEachOrderAndFindsTheAnglesAgain) {
  constexpr double kDegree = std::numbers::pi / 180;
  const Vector3d degrees(30, 40, 50);
  const Eigen::Matrix3d yzx = (AngleAxisd(degrees.x() * kDegree, Vector3d::UnitX()) *
                               AngleAxisd(degrees.z() * kDegree, Vector3d::UnitZ()) *
                               AngleAxisd(degrees.y() * kDegree, Vector3d::UnitY()))
                                  .toRotationMatrix();
  EXPECT_LT((fbx_rotation(degrees, 2).toRotationMatrix() - yzx).norm(), 1e-12);
  for (int order = 0; order < kFbxOrders; ++order)
    EXPECT_LT((fbx_angles(fbx_rotation(degrees, order), order) - degrees).norm(), 1e-9) << order;
}

TEST(FbxTransform, TakesOverTheScaleOfItsParentAsItsInheritTypeSays) {
  LocalTransform parent;
  parent.scale = {2, 5, 1};
  LocalTransform child;
  child.translation = {1, 1, 0};
  child.rotation = AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ());
  child.scale = {3, 1, 1};
  const auto tip = [&](ScaleOfParent inherit) {
    child.inherit = inherit;
    const NodePlacement placed = below(below(file_placement(1, UpAxis::Y), parent), child);
    EXPECT_LT((placed.origin - Vector3d(2, 5, 0)).norm(), 1e-12);
    return Vector3d(placed.world_from_node * Vector3d::UnitX());
  };
  EXPECT_LT((tip(ScaleOfParent::Whole) - Vector3d(0, 15, 0)).norm(), 1e-12);
  EXPECT_LT((tip(ScaleOfParent::ByAxis) - Vector3d(0, 6, 0)).norm(), 1e-12);
  EXPECT_LT((tip(ScaleOfParent::None) - Vector3d(0, 3, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace mocapress::fbx_transform_test
