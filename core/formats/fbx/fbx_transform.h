// SPDX-License-Identifier: MIT
// The transform of an FBX node, which has more parts than in other formats.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>

#include "core/formats/fbx/fbx_objects.h"
#include "core/formats/node_motion.h"

namespace mocapress {

/// The rotation by three angles (degrees) in one of FBX's orders: 0 is XYZ, which turns about X
/// first.
Eigen::Quaterniond fbx_rotation(const Eigen::Vector3d& degrees, int order = 0);

/// The angles (degrees) of a rotation in one of FBX's orders; of the two solutions the one nearer
/// to `near`.
Eigen::Vector3d fbx_angles(const Eigen::Quaterniond& rotation, int order,
                           const Eigen::Vector3d& near = Eigen::Vector3d::Zero());

/// The axes of one of FBX's orders, in the order of turning.
const int* fbx_axes(int order);

inline constexpr int kFbxOrders = 7;  // the last one, spheric XYZ, is read as XYZ

/// parent_from_node = T * Roff * Rp * Rpre * R * Rpost^-1 * Rp^-1 * Soff * Sp * S * Sp^-1
/// (Autodesk, "Computing transformation matrices").
struct FbxTransform {
  explicit FbxTransform(const FbxProperties& node);
  FbxTransform() = default;

  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  // degrees
  Eigen::Vector3d scaling = Eigen::Vector3d::Ones();
  Eigen::Vector3d pre_rotation = Eigen::Vector3d::Zero();
  Eigen::Vector3d post_rotation = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_pivot = Eigen::Vector3d::Zero();
  Eigen::Vector3d scaling_offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d scaling_pivot = Eigen::Vector3d::Zero();
  int order = 0;
  bool is_spheric = false;
  ScaleOfParent inherit = ScaleOfParent::Whole;

  /// The part of the transform that curves of this property move; null: none.
  Eigen::Vector3d* part(std::string_view property);

  /// The rotations before and after the one by the `rotation` angles.
  struct Turns {
    Eigen::Quaterniond before;
    Eigen::Quaterniond after;
  };
  Turns turns() const;

  LocalTransform local() const { return local(turns()); }
  LocalTransform local(const Turns& turns) const;
  /// Sets translation, rotation and scaling so that local() returns this transform, with angles
  /// nearest to the current ones.
  void set_local(const LocalTransform& local);

 private:
  Eigen::Vector3d within_pivots() const;
};

/// The transform of a node's geometry, which its children do not inherit.
Eigen::Affine3d fbx_geometric_transform(const FbxProperties& node);

}  // namespace mocapress
