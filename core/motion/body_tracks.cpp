// SPDX-License-Identifier: MIT
#include "core/motion/body_tracks.h"

#include <cassert>
#include <numbers>

namespace mocapress {

Eigen::MatrixXd body_tracks(const Skeleton& skeleton, const Clip& clip) {
  std::vector<Landmark> points = landmarks(skeleton);
  const std::vector<Landmark> shell = shell_points(skeleton);
  points.insert(points.end(), shell.begin(), shell.end());
  return point_tracks(skeleton, points, clip);
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

}  // namespace mocapress
