// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_transform.h"

#include <array>
#include <numbers>
#include <utility>

#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kRadians = std::numbers::pi / 180;

constexpr int kAxes[kFbxOrders][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2},
                                      {2, 0, 1}, {2, 1, 0}, {0, 1, 2}};

constexpr std::pair<std::string_view, Vector3d FbxTransform::*> kParts[] = {
    {"Lcl Translation", &FbxTransform::translation},
    {"Lcl Rotation", &FbxTransform::rotation},
    {"Lcl Scaling", &FbxTransform::scaling},
    {"PreRotation", &FbxTransform::pre_rotation},
    {"PostRotation", &FbxTransform::post_rotation},
    {"RotationOffset", &FbxTransform::rotation_offset},
    {"RotationPivot", &FbxTransform::rotation_pivot},
    {"ScalingOffset", &FbxTransform::scaling_offset},
    {"ScalingPivot", &FbxTransform::scaling_pivot},
};

}  // namespace

const int* fbx_axes(int order) {
  return kAxes[order >= 0 && order < kFbxOrders ? order : 0];
}

Quaterniond fbx_rotation(const Vector3d& degrees, int order) {
  Quaterniond rotation = Quaterniond::Identity();
  const int* const axes = fbx_axes(order);
  for (int i = 0; i < 3; ++i)  // a later rotation is about the parent's axes
    rotation = Eigen::AngleAxisd(kRadians * degrees(axes[i]), Vector3d::Unit(axes[i])) * rotation;
  return rotation;
}

Vector3d fbx_angles(const Quaterniond& rotation, int order, const Vector3d& near) {
  const int* const axes = fbx_axes(order);
  const std::array<int, 3> leftmost_first = {axes[2], axes[1], axes[0]};
  Vector3d turned;
  for (int i = 0; i < 3; ++i) turned(i) = kRadians * near(axes[2 - i]);
  turned = three_angles(leftmost_first, rotation.normalized().toRotationMatrix(), turned);
  Vector3d degrees;
  for (int i = 0; i < 3; ++i) degrees(axes[2 - i]) = turned(i) / kRadians;
  return degrees;
}

FbxTransform::FbxTransform(const FbxProperties& node) {
  for (const auto& [name, part] : kParts) this->*part = node.vector(name, this->*part);
  const auto stated = static_cast<int>(node.number("RotationOrder", 0));
  order = stated >= 0 && stated < kFbxOrders ? stated : 0;
  // Pre-rotation, post-rotation and order apply only to nodes with RotationActive. Files without
  // that property are meant to apply them.
  if (node.number("RotationActive", 1) == 0) {
    pre_rotation = post_rotation = Vector3d::Zero();
    order = 0;
  }
  is_spheric = order == kFbxOrders - 1;
  switch (static_cast<int>(node.number("InheritType", 1))) {
    case 0:
      inherit = ScaleOfParent::ByAxis;
      break;
    case 2:
      inherit = ScaleOfParent::None;
      break;
    default:
      break;
  }
}

Vector3d* FbxTransform::part(std::string_view property) {
  for (const auto& [name, part] : kParts)
    if (name == property) return &(this->*part);
  return nullptr;
}

FbxTransform::Turns FbxTransform::turns() const {
  return {fbx_rotation(pre_rotation), fbx_rotation(post_rotation).conjugate()};
}

LocalTransform FbxTransform::local(const Turns& turns) const {
  LocalTransform local;
  local.rotation = turns.before * fbx_rotation(rotation, order) * turns.after;
  local.scale = scaling;
  local.inherit = inherit;
  local.translation = translation + rotation_offset + rotation_pivot;
  if (const Vector3d within = within_pivots(); !within.isZero(0))
    local.translation += local.rotation * within;
  return local;
}

void FbxTransform::set_local(const LocalTransform& local) {
  const Quaterniond turn = local.rotation.normalized();
  scaling = local.scale;
  rotation = fbx_angles(fbx_rotation(pre_rotation).conjugate() * turn * fbx_rotation(post_rotation),
                        order, rotation);
  translation = local.translation - rotation_offset - rotation_pivot - turn * within_pivots();
}

/// The offset from the rotation pivot to the origin, in the rotated node's axes.
Vector3d FbxTransform::within_pivots() const {
  return scaling_offset + scaling_pivot - rotation_pivot - scaling.cwiseProduct(scaling_pivot);
}

Eigen::Affine3d fbx_geometric_transform(const FbxProperties& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.translate(node.vector("GeometricTranslation", Vector3d::Zero()));
  transform.rotate(fbx_rotation(node.vector("GeometricRotation", Vector3d::Zero())));
  transform.scale(node.vector("GeometricScaling", Vector3d::Ones()));
  return transform;
}

}  // namespace mocapress
