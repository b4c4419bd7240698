// SPDX-License-Identifier: MIT
#include "core/motion/body_tracks.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "core/motion/landmarks.h"
#include "core/motion/pose_block.h"

namespace mocapress {

Eigen::MatrixXd body_tracks(const Skeleton& skeleton, const Clip& clip) {
  const std::vector<Landmark> points = landmarks(skeleton);
  const Eigen::Index shell = 3 * std::ssize(points);
  const Eigen::Index joints = skeleton.joint_count();
  Eigen::MatrixXd tracks(clip.frames(), shell + 9 * joints);
  visit_poses(skeleton, clip.channels, [&](const PoseBlock& poses, int first, int frames) {
    place_landmarks(points, poses, first, frames, tracks);
    // The points of shell_points(): of each joint along its axes.
    for (int j = 0; j < skeleton.joint_count(); ++j)
      for (int axis = 0; axis < 3; ++axis)
        tracks.block(first, shell + 9 * j + 3 * axis, frames, 3) =
            (poses.origin(j) + kShellRadius * poses.axis(j, axis)).matrix();
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
