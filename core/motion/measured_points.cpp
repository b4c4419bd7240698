// SPDX-License-Identifier: MIT
#include "core/motion/measured_points.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/motion/body.h"

namespace mocapress {
namespace {

MeasuredPoints surface_points(const Skeleton& skeleton) {
  const double kNear = 0.5 - 1 / std::sqrt(12.0);  // of the axis, where Gauss has his two points
  MeasuredPoints surface;
  std::vector<double> weights;
  for (const BodyLimb& limb : body_limbs(skeleton)) {
    Eigen::Index least = 0;
    limb.axis_in_joint.cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d across =
        limb.axis_in_joint.cross(Eigen::Vector3d::Unit(least)).normalized();
    const Eigen::Vector3d aside = limb.axis_in_joint.cross(across).normalized();
    const auto put = [&](double along, const Eigen::Vector3d& off) {
      surface.points.push_back({limb.joint, along * limb.axis_in_joint + limb.radius * off,
                                skeleton.joint(limb.joint).name});
      weights.push_back(limb.share / 4);
    };
    put(kNear, across);
    put(kNear, -across);
    put(1 - kNear, aside);
    put(1 - kNear, -aside);
  }
  surface.weights =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return surface;
}

MeasuredPoints evenly(std::vector<Landmark> points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  return {std::move(points),
          Eigen::VectorXd::Constant(count,
                                    1.0 / static_cast<double>(std::max<Eigen::Index>(count, 1)))};
}

}  // namespace

std::vector<Landmark> shell_points(const Skeleton& skeleton) {
  std::vector<Landmark> points;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    for (int axis = 0; axis < 3; ++axis)
      points.push_back({j, kShellRadius * Eigen::Vector3d::Unit(axis), skeleton.joint(j).name});
  return points;
}

MeasuredPoints measured_points(const Skeleton& skeleton, Weighting weighting) {
  if (is_on_bones(weighting)) return {landmarks(skeleton), landmark_weights(skeleton, weighting)};
  if (weighting == Weighting::Surface)
    if (MeasuredPoints surface = surface_points(skeleton); !surface.points.empty()) return surface;
  return evenly(shell_points(skeleton));
}

}  // namespace mocapress
