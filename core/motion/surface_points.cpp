// SPDX-License-Identifier: MIT
#include "core/motion/surface_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/motion/body.h"
#include "core/motion/skin_points.h"

namespace mocapress {
namespace {

constexpr double kMuchFurther = 2;

struct SurfacePoint {
  int joint;
  Eigen::Vector3d in_joint;  // cm
  double weight;
};
using Surface = std::vector<SurfacePoint>;

Surface around_bones(const Skeleton& skeleton) {
  const double kNear = 0.5 - 1 / std::sqrt(12.0);  // share of the axis: Gauss' two-point quadrature
  Surface surface;
  for (const BodyLimb& limb : body_limbs(skeleton)) {
    Eigen::Index least = 0;
    limb.axis_in_joint.cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d across =
        limb.axis_in_joint.cross(Eigen::Vector3d::Unit(least)).normalized();
    const Eigen::Vector3d aside = limb.axis_in_joint.cross(across).normalized();
    const auto put = [&](double along, const Eigen::Vector3d& off) {
      surface.push_back(
          {limb.joint, along * limb.axis_in_joint + limb.radius * off, limb.share / 4});
    };
    put(kNear, across);
    put(kNear, -across);
    put(1 - kNear, aside);
    put(1 - kNear, -aside);
  }
  if (!surface.empty()) return surface;
  const std::vector<Landmark> shell = shell_points(skeleton);
  for (const Landmark& point : shell)
    surface.push_back({point.joint, point.in_joint, 1.0 / static_cast<double>(shell.size())});
  return surface;
}

/// Replaces the points of joints whose mesh reaches much further out than the body around their
/// bones.
std::vector<FarMesh> follow_mesh(const Skeleton& skeleton, Surface& surface) {
  std::vector<FarMesh> far;
  if (!skeleton.skin()) return far;
  struct OfJoint {
    double weight = 0;
    double squares = 0;  // cm^2, weighted
  };
  std::vector<OfJoint> bodies(skeleton.joint_count());
  for (const SurfacePoint& point : surface) {
    OfJoint& body = bodies[point.joint];
    body.weight += point.weight;
    body.squares += point.weight * point.in_joint.squaredNorm();
  }
  for (const CarriedMesh& mesh : carried_meshes(*skeleton.skin())) {
    double squares = 0;  // cm^2
    for (const Eigen::Vector3d& in_joint : mesh.in_joint) squares += in_joint.squaredNorm() / 4;
    const OfJoint& body = bodies[mesh.joint];
    const double body_cm = body.weight > 0 ? std::sqrt(body.squares / body.weight) : 0;
    const double mesh_cm = std::sqrt(squares);
    if (mesh_cm <= kMuchFurther * std::max(body_cm, kShellRadius)) continue;
    far.push_back({mesh.joint, mesh_cm, body_cm});
    std::erase_if(surface, [&](const SurfacePoint& point) { return point.joint == mesh.joint; });
    for (const Eigen::Vector3d& in_joint : mesh.in_joint)
      surface.push_back({mesh.joint, in_joint, (body.weight > 0 ? body.weight : mesh.share) / 4});
  }
  if (far.empty()) return far;
  double weight = 0;
  for (const SurfacePoint& point : surface) weight += point.weight;
  for (SurfacePoint& point : surface) point.weight /= weight;
  return far;
}

}  // namespace

MeasuredPoints surface_points(const Skeleton& skeleton) {
  Surface surface = around_bones(skeleton);
  follow_mesh(skeleton, surface);
  MeasuredPoints measured;
  measured.weights.resize(std::ssize(surface));
  for (std::size_t p = 0; p < surface.size(); ++p) {
    const auto& [joint, in_joint, weight] = surface[p];
    measured.points.push_back({joint, in_joint, skeleton.joint(joint).name});
    measured.weights(p) = weight;
  }
  return measured;
}

std::vector<FarMesh> far_meshes(const Skeleton& skeleton) {
  Surface surface = around_bones(skeleton);
  return follow_mesh(skeleton, surface);
}

}  // namespace mocapress
