// SPDX-License-Identifier: MIT
#include "core/baselines/virtual_markers.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

using Markers = Eigen::Map<const Eigen::Matrix3d>;  // columns: the three markers of a joint

/// The rotation whose columns come nearest to the markers' offsets from their mean (least squares).
Eigen::Matrix3d orientation(const Eigen::Matrix3d& markers) {
  const Eigen::Matrix3d arms = markers.colwise() - markers.rowwise().mean();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(arms, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if (u.determinant() * svd.matrixV().determinant() < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

}  // namespace

VirtualMarkers::VirtualMarkers(const Skeleton& skeleton) : skeleton_(skeleton) {
  constexpr double kShortestArm = 5;  // cm
  const std::vector<double> lengths = skeleton.driven_lengths();
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    const bool root = joint.parent < 0;
    roots_.push_back(root ? j : roots_[joint.parent]);
    if (!root && turns(joint)) places_.push_back({j, std::max(lengths[j], kShortestArm)});
    for (std::size_t i = 0; i < joint.channels.size(); ++i)
      (root || !is_rotation(joint.channels[i]) ? other_channels_ : angles_)
          .push_back(skeleton.first_channel(j) + static_cast<int>(i));
  }
}

Eigen::RowVectorXd VirtualMarkers::of(const FrameRow& frame) const {
  Pose pose;
  compute_pose(skeleton_, frame, pose);
  Eigen::RowVectorXd markers(coordinates());
  Eigen::Index next = 0;
  for (const Place& place : places_) {
    const auto j = static_cast<std::size_t>(place.joint);
    const auto root = static_cast<std::size_t>(roots_[j]);
    const Eigen::Matrix3d root_from_world = pose.world_from_joint[root].transpose();
    const Eigen::Vector3d origin = root_from_world * (pose.origin[j] - pose.origin[root]);
    const Eigen::Matrix3d arms = place.arm * root_from_world * pose.world_from_joint[j];
    markers.segment<9>(next) = (arms.colwise() + origin).reshaped().transpose();
    next += 9;
  }
  return markers;
}

void VirtualMarkers::turn(const Eigen::RowVectorXd& markers, Eigen::RowVectorXd& frame) const {
  std::vector<Eigen::Matrix3d> root_from_joint(skeleton_.joint_count(),
                                               Eigen::Matrix3d::Identity());
  const double* next = markers.data();
  for (int j = 0; j < skeleton_.joint_count(); ++j) {
    const Joint& joint = skeleton_.joint(j);
    if (joint.parent < 0) continue;
    Eigen::Matrix3d& result = root_from_joint[j];
    result = root_from_joint[joint.parent];
    if (!turns(joint)) continue;
    // Starts from the decoded rotation of the parent, so that a joint corrects what its parent
    // could not reach.
    const Eigen::Matrix3d axes = joint.joint_from_axes;
    const Eigen::Matrix3d wanted =
        axes.transpose() * result.transpose() * orientation(Markers(next)) * axes;
    Eigen::RowVectorXd values =
        frame.segment(skeleton_.first_channel(j), std::ssize(joint.channels));
    turn_joint(joint, wanted, values);
    frame.segment(skeleton_.first_channel(j), values.size()) = values;
    result *= axes * joint_rotation(joint, values) * axes.transpose();
    next += 9;
  }
}

}  // namespace mocapress
