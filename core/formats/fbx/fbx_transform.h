// SPDX-License-Identifier: MIT
// The transform of an FBX node, of more parts than other formats have.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>

#include "core/formats/fbx/fbx_objects.h"
#include "core/formats/node_motion.h"

namespace mocapress {

/// The turn that three angles (degrees) make, in one of FBX's orders: 0 is XYZ, about X first.
Eigen::Quaterniond fbx_rotation(const Eigen::Vector3d& degrees, int order = 0);

/// The angles in that order that make a turn, degrees: those nearest to `near`.
Eigen::Vector3d fbx_angles(const Eigen::Quaterniond& rotation, int order,
                           const Eigen::Vector3d& near = Eigen::Vector3d::Zero());

/// The axes of an order, the first one to turn about in front.
const int* fbx_axes(int order);

inline constexpr int kFbxOrders = 7;  // the last, spheric XYZ, is read as XYZ

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

  /// The part of that name, which a curve may move; null: none.
  Eigen::Vector3d* part(std::string_view property);

  LocalTransform local() const;
  /// Moves, turns and scales it so that local() is this, by the angles nearest to those it has.
  void set_local(const LocalTransform& local);

 private:
  Eigen::Vector3d within_pivots() const;
};

/// What only the geometry of a node has, not its children.
Eigen::Affine3d fbx_geometric_transform(const FbxProperties& node);

}  // namespace mocapress
