// SPDX-License-Identifier: MIT
// Based on: M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018 (places
// within triangles).
#include "core/motion/skin_points.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace mocapress {
namespace {

using Eigen::Vector3d;

constexpr int kPoints = 512;
constexpr double kGoodPart = 0.25;  // least weight of a joint at a point

double area_of(const Skin& skin, const std::array<std::uint32_t, 3>& triangle) {
  const auto at = [&](std::size_t corner) -> const Eigen::Vector3f& {
    return skin.vertices[triangle[corner]].in_bind;
  };
  return (at(1) - at(0)).cross(at(2) - at(0)).cast<double>().norm() / 2;
}

/// A point in a triangle, by its shares of the corners. Engines move the vertices, and a point
/// between them moves linearly with them, so the point is linear in the joints' poses as well.
SkinPoint point_in(const Skin& skin, const std::array<std::uint32_t, 3>& triangle,
                   const Vector3d& shares_of_corners) {
  std::map<int, SkinPointShare> by_joint;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Skin::Vertex& vertex = skin.vertices[triangle[corner]];
    for (std::size_t i = 0; i < vertex.carried_by.weights.size(); ++i) {
      const double weight =
          shares_of_corners(corner) * static_cast<double>(vertex.carried_by.weights[i]);
      if (!(weight > 0)) continue;
      const SkinBone& bone = skin.bones[vertex.carried_by.bones[i]];
      SkinPointShare& share =
          by_joint.try_emplace(bone.joint, SkinPointShare{bone.joint, Vector3d::Zero(), 0})
              .first->second;
      share.in_joint += weight * (bone.joint_from_bind * vertex.in_bind.cast<double>());
      share.weight += weight;
    }
  }
  SkinPoint point;
  double sum = 0;
  for (const auto& [joint, share] : by_joint) sum += share.weight;
  for (auto& [joint, share] : by_joint)
    point.push_back({joint, share.in_joint / share.weight, share.weight / sum});
  std::ranges::stable_sort(point, [](const auto& a, const auto& b) { return a.weight > b.weight; });
  return point;
}

/// Moments of the points that one joint carries.
struct Carried {
  double weight = 0;
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};

}  // namespace

SkinPoints points_on(const Skin& skin) {
  std::vector<double> areas_before;
  double area = 0;
  for (const auto& triangle : skin.triangles) {
    areas_before.push_back(area);
    area += area_of(skin, triangle);
  }
  SkinPoints points;
  if (!(area > 0)) return points;
  for (int i = 0; i < kPoints; ++i) {
    const double wanted = (i + 0.5) / kPoints * area;
    const auto next = std::ranges::upper_bound(areas_before, wanted);
    const auto& triangle =
        skin.triangles[static_cast<std::size_t>(next - areas_before.begin()) - 1];
    constexpr double kPlastic = 1.32471795724474602596;
    double u = std::fmod(0.5 + i / kPlastic, 1.0);
    double v = std::fmod(0.5 + i / (kPlastic * kPlastic), 1.0);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    points.push_back(point_in(skin, triangle, {1 - u - v, u, v}));
  }
  return points;
}

void measure_on(const Skin* skin, Skeleton& skeleton) {
  SkinPoints points;
  if (skin) points = points_on(*skin);
  skeleton.set_skin(points.empty() ? nullptr
                                   : std::make_shared<const SkinPoints>(std::move(points)));
}

std::vector<CarriedMesh> carried_meshes(const SkinPoints& skin) {
  std::map<int, Carried> by_joint;
  for (const SkinPoint& point : skin)
    for (const auto& [joint, in_joint, weight] : point) {
      Carried& carried = by_joint[joint];
      carried.weight += weight;
      carried.sum += weight * in_joint;
      carried.squares += weight * in_joint * in_joint.transpose();
    }
  std::vector<CarriedMesh> meshes;
  for (const auto& [joint, carried] : by_joint) {
    const Vector3d mean = carried.sum / carried.weight;
    const Eigen::Matrix3d around = carried.squares / carried.weight - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(around);
    const Eigen::Matrix3d root =
        axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
    // Corners of a tetrahedron with mean 0 and the second moments of a unit ball.
    meshes.push_back({joint,
                      carried.weight / static_cast<double>(skin.size()),
                      {mean + root * Vector3d(1, 1, 1), mean + root * Vector3d(1, -1, -1),
                       mean + root * Vector3d(-1, 1, -1), mean + root * Vector3d(-1, -1, 1)}});
  }
  return meshes;
}

MeasuredPoints carried_points(const SkinPoints& skin, const Skeleton& skeleton) {
  MeasuredPoints measured;
  std::vector<double> weights;
  for (const CarriedMesh& mesh : carried_meshes(skin))
    for (const Vector3d& in_joint : mesh.in_joint) {
      measured.points.push_back({mesh.joint, in_joint, skeleton.joint(mesh.joint).name});
      weights.push_back(mesh.share / 4);
    }
  measured.weights =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return measured;
}

std::vector<Landmark> corners_of(const SkinPoints& skin, const Skeleton& skeleton) {
  std::map<int, Eigen::AlignedBox3d> boxes;
  for (const SkinPoint& point : skin)
    for (const auto& [joint, in_joint, weight] : point)
      if (weight >= kGoodPart) boxes[joint].extend(in_joint);
  std::vector<Landmark> corners;
  for (const auto& [joint, box] : boxes)
    for (int corner = 0; corner < 8; ++corner)
      corners.push_back({joint, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)),
                         skeleton.joint(joint).name});
  return corners;
}

}  // namespace mocapress
