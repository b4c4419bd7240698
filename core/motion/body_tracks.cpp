// SPDX-License-Identifier: MIT
#include "core/motion/body_tracks.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "core/base/parallel.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"

namespace mocapress {

Eigen::MatrixXd body_tracks(const Skeleton& skeleton, const Clip& clip) {
  const std::vector<Landmark> points = landmarks(skeleton);
  const Eigen::Index shell = 3 * std::ssize(points);
  const Eigen::Index joints = skeleton.joint_count();
  Eigen::MatrixXd tracks(clip.frames(), shell + 9 * joints);
  parallel_ranges(0, clip.frames(), 64, [&](int first, int end) {
    Pose pose;
    for (int t = first; t < end; ++t) {
      compute_pose(skeleton, clip.channels.row(t), pose);
      place_landmarks(points, pose, t, tracks);
      // The points of shell_points(): of each joint along its axes.
      for (Eigen::Index j = 0; j < joints; ++j) {
        const auto& origin = pose.origin[static_cast<std::size_t>(j)];
        const auto& axes = pose.world_from_joint[static_cast<std::size_t>(j)];
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          for (Eigen::Index i = 0; i < 3; ++i)
            tracks(t, shell + 9 * j + 3 * axis + i) = origin(i) + kShellRadius * axes(i, axis);
      }
    }
  });
  return tracks;
}

JointErrors::JointErrors(const Skeleton& skeleton,
                         const Eigen::Ref<const Eigen::MatrixXd>& original,
                         const Eigen::Ref<const Eigen::MatrixXd>& decoded)
    : original_(original),
      decoded_(decoded),
      shell_(original.cols() - Eigen::Index{9} * skeleton.joint_count()) {
  assert(original.rows() == decoded.rows() && original.cols() == decoded.cols() && shell_ >= 0);
}

Eigen::Matrix<double, Eigen::Dynamic, 12> JointErrors::of(int joint) const {
  Eigen::Matrix<double, Eigen::Dynamic, 12> errors(original_.rows(), 12);
  const Eigen::Index origin = Eigen::Index{3} * joint;
  errors.leftCols<3>() = decoded_.middleCols<3>(origin) - original_.middleCols<3>(origin);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index column = shell_ + Eigen::Index{9} * joint + 3 * axis;
    errors.middleCols<3>(3 + 3 * axis) =
        (decoded_.middleCols<3>(column) - original_.middleCols<3>(column) - errors.leftCols<3>()) /
        kShellRadius;
  }
  return errors;
}

Eigen::VectorXd JointErrors::squared(const Eigen::Matrix<double, Eigen::Dynamic, 12>& of_joint,
                                     const Eigen::Vector3d& in_joint) {
  return (of_joint.leftCols<3>() + in_joint.x() * of_joint.middleCols<3>(3) +
          in_joint.y() * of_joint.middleCols<3>(6) + in_joint.z() * of_joint.middleCols<3>(9))
      .rowwise()
      .squaredNorm();
}

Eigen::VectorXd JointErrors::degrees(const Eigen::Matrix<double, Eigen::Dynamic, 12>& of_joint) {
  // Of a rotation by the angle a, the axes' squared differences come to 8 sin(a / 2)^2.
  const Eigen::ArrayXd sine =
      (of_joint.rightCols<9>().rowwise().squaredNorm() / 8).array().min(1).sqrt();
  return (360 / std::numbers::pi) * sine.asin();
}

void visit_tracks(const Skeleton& skeleton, const Clip& clip, const TrackBlock& visit) {
  constexpr int kBlock = 8192;
  if (clip.frames() <= kBlock) return visit(0, body_tracks(skeleton, clip));
  for (int first = 0; first < clip.frames(); first += kBlock) {
    const int count = std::min(kBlock, clip.frames() - first);
    visit(first,
          body_tracks(skeleton, Clip{clip.sample_rate_hz, clip.channels.middleRows(first, count)}));
  }
}

}  // namespace mocapress
