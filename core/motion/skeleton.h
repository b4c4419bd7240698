// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/channel.h"

namespace mocapress {

/// One joint, with the frame it carries. A point moves from the joint's frame to its parent's by
///
///   x_in_parent = offset + translation + rotation * x_in_joint
///   rotation    = joint_from_axes * R * joint_from_axes^T
///   R           = before * (the product of the rotation channels, the first leftmost) * after
///
/// where `translation` gathers the translation channels. `joint_from_axes` is ASF's `axis`; in BVH
/// it is identity. No source has `before` and `after`: they suit coded angles to how a joint moves
/// (RotationForm).
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

/// rotation = parent_from_axes * (the product of the rotation channels) * axes_from_joint
struct JointAxes {
  Eigen::Matrix3d parent_from_axes;
  Eigen::Matrix3d axes_from_joint;
};

/// A bone: from a joint's origin to where a child joint or an end site sits.
struct Segment {
  int joint;                     // the joint that drives it
  int child;                     // the joint at its far end, -1 for an end site
  Eigen::Vector3d end_in_joint;  // cm
  double length;                 // cm
};

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

  /// The joint of that name, or -1.
  int find(const std::string& name) const;

  /// Every segment, in the order of the driving joints.
  std::vector<Segment> segments() const;

  /// Summed length (cm) of the segments each joint drives.
  std::vector<double> driven_lengths() const;

 private:
  std::vector<Joint> joints_;
  std::vector<JointAxes> axes_;
  std::vector<int> first_channels_;
  std::vector<int> channel_joints_;
};

}  // namespace mocapress
