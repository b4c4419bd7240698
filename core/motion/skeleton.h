// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mocapress {

/// The quantity that one degree of freedom moves. The values are part of the file format: never
/// reassign one.
enum class ChannelKind : std::uint8_t {
  TranslationX = 0,  // cm
  TranslationY = 1,
  TranslationZ = 2,
  RotationX = 3,  // radians
  RotationY = 4,
  RotationZ = 5,
};

inline constexpr int kChannelKinds = 6;

constexpr bool is_rotation(ChannelKind kind) {
  return kind >= ChannelKind::RotationX;
}

/// 0, 1 or 2 for X, Y or Z.
constexpr int axis_of(ChannelKind kind) {
  return static_cast<int>(kind) % 3;
}

constexpr ChannelKind translation_about(int axis) {
  return static_cast<ChannelKind>(axis);
}
constexpr ChannelKind rotation_about(int axis) {
  return static_cast<ChannelKind>(3 + axis);
}

/// "tx" ... "rz".
std::string_view short_name(ChannelKind kind);

/// The rotation by `radians` about coordinate axis 0, 1 or 2.
Eigen::Matrix3d axis_rotation(int axis, double radians);

/// The shortest turn from one direction to another. Lengths do not matter, but must not be zero.
Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// One joint, with the frame it carries. A point moves from the joint's frame to its parent's by
///
///   x_in_parent = offset + translation + rotation * x_in_joint
///   rotation    = joint_from_axes * R * joint_from_axes^T
///   R           = before * (the product of the rotation channels, the first leftmost) * after
///
/// where `translation` gathers the translation channels. `joint_from_axes` is ASF's `axis`; in BVH
/// it is identity. Sources never set `before` and `after`: they fit coded angles to the joint's
/// movement (RotationForm).
struct Joint {
  std::string name;
  int parent = -1;                                   // -1: a root
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // cm, in the parent's frame
  Eigen::Matrix3d joint_from_axes = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d before = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d after = Eigen::Matrix3d::Identity();
  std::vector<ChannelKind> channels;        // in the order of the product above
  std::optional<Eigen::Vector3d> end_site;  // cm, in the joint's frame; leaves only
};

/// A joint's constant rotations: rotation = parent_from_axes * (the product of the rotation
/// channels) * axes_from_joint
struct JointAxes {
  Eigen::Matrix3d parent_from_axes;
  Eigen::Matrix3d axes_from_joint;
};

/// A bone: from a joint's origin to a child joint or an end site.
struct Segment {
  int joint;                     // the joint that drives it
  int child;                     // the joint at its far end, -1 for an end site
  Eigen::Vector3d end_in_joint;  // cm
  double length;                 // cm
};

/// One joint's share of a point on a character's surface. The point lies at the weighted mean of
/// its shares. Weights sum to 1; the largest comes first.
struct SkinPointShare {
  int joint;
  Eigen::Vector3d in_joint;  // cm
  double weight;
};
using SkinPoint = std::vector<SkinPointShare>;
using SkinPoints = std::vector<SkinPoint>;

/// Joints in parent-first order, so that one forward loop visits every parent before its children.
class Skeleton {
 public:
  /// Appends a joint and returns its index. Requires joint.parent < joint_count().
  int add(Joint joint);

  int joint_count() const { return static_cast<int>(joints_.size()); }
  const Joint& joint(int index) const { return joints_[static_cast<std::size_t>(index)]; }
  const std::vector<Joint>& joints() const { return joints_; }
  const JointAxes& axes(int joint) const { return axes_[static_cast<std::size_t>(joint)]; }

  /// Channels are numbered joint by joint, in each joint's order.
  int channel_count() const { return static_cast<int>(channel_joints_.size()); }
  int first_channel(int joint) const { return first_channels_[static_cast<std::size_t>(joint)]; }
  int channel_joint(int channel) const {
    return channel_joints_[static_cast<std::size_t>(channel)];
  }
  ChannelKind channel_kind(int channel) const;

  /// "lfemur.rx".
  std::string channel_name(int channel) const;

  /// The joint with this name, or -1.
  int find(const std::string& name) const;

  /// Every segment, in the order of their driving joints.
  std::vector<Segment> segments() const;

  /// The points of the mesh that Weighting::Skin measures. Null: no mesh is known.
  const std::shared_ptr<const SkinPoints>& skin() const { return skin_; }
  void set_skin(std::shared_ptr<const SkinPoints> skin) { skin_ = std::move(skin); }

  /// Summed length (cm) of the segments each joint drives.
  std::vector<double> driven_lengths() const;

 private:
  std::vector<Joint> joints_;
  std::vector<JointAxes> axes_;
  std::vector<int> first_channels_;
  std::vector<int> channel_joints_;
  std::shared_ptr<const SkinPoints> skin_;
};

}  // namespace mocapress
