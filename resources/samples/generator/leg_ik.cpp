// SPDX-License-Identifier: MIT
#include "resources/samples/generator/leg_ik.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/formats/zyx_angles.h"

namespace mocapress::samples {
namespace {

constexpr double kLeastFlexion = 1;  // degrees
constexpr double kMostFlexion = 150;

/// The turn about the unit vector `axis` after which w is perpendicular to u. There are two (one
/// bends the knee backwards): returns the one that leaves `hinge` nearer to u.
double turn_to_perpendicular(const Eigen::Vector3d& axis, const Eigen::Vector3d& w,
                             const Eigen::Vector3d& u, const Eigen::Vector3d& hinge) {
  const double constant = u.dot(axis) * axis.dot(w);
  const double cosine = u.dot(w) - constant;
  const double sine = u.dot(axis.cross(w));
  const double middle = std::atan2(sine, cosine);
  const double half = std::acos(std::clamp(-constant / std::hypot(cosine, sine), -1.0, 1.0));
  const auto agreement = [&](double turn) { return u.dot(Eigen::AngleAxisd(turn, axis) * hinge); };
  return agreement(middle + half) > agreement(middle - half) ? middle + half : middle - half;
}

double knee_flexion(double hip_to_ankle) {
  const double reach =
      std::clamp(hip_to_ankle, leg_length(kMostFlexion), leg_length(kLeastFlexion));
  const double cosine =
      (reach * reach - kThighLength * kThighLength - kShankLength * kShankLength) /
      (2 * kThighLength * kShankLength);
  return std::acos(cosine);
}

}  // namespace

double leg_length(double knee_degrees) {
  return std::sqrt(kThighLength * kThighLength + kShankLength * kShankLength +
                   2 * kThighLength * kShankLength * std::cos(in_radians(knee_degrees)));
}

void place_foot(Posture& posture, Side side, const FootState& foot) {
  const Eigen::Matrix3d world_from_pelvis = world_from_root(posture);
  const Eigen::Vector3d hip = posture.root + world_from_pelvis * mirrored_offset(side, kHipInRoot);
  const Eigen::Vector3d leg = foot.ankle - hip;
  const double knee = knee_flexion(leg.norm());
  const Eigen::Matrix3d femur_from_tibia = axis_rotation(0, knee);
  const Eigen::Vector3d leg_in_femur =
      -Eigen::Vector3d::UnitY() * kThighLength - femur_from_tibia.col(1) * kShankLength;

  // Any thigh that points the leg at the ankle, then the turn about the leg that lets the two
  // angles of the foot, about its x and the shank's z, do the rest.
  const Eigen::Matrix3d world_from_foot = foot.world_from_foot();
  const Eigen::Vector3d axis = leg.normalized();
  Eigen::Matrix3d world_from_femur =
      shortest_turn(world_from_pelvis * leg_in_femur, leg) * world_from_pelvis;
  const double turn = turn_to_perpendicular(axis, world_from_femur * femur_from_tibia.col(2),
                                            world_from_foot.col(0), world_from_femur.col(0));
  world_from_femur = Eigen::AngleAxisd(turn, axis).toRotationMatrix() * world_from_femur;

  const Eigen::Matrix3d tibia_from_foot =
      (world_from_femur * femur_from_tibia).transpose() * world_from_foot;
  const auto angles = [](const Eigen::Matrix3d& rotation) {
    return Eigen::Vector3d(in_degrees(1) * zyx_angles(rotation, Eigen::Vector3d::Zero()));
  };
  posture.degrees[sided(side, "femur")] = angles(world_from_pelvis.transpose() * world_from_femur);
  posture.degrees[sided(side, "tibia")] = {in_degrees(knee), 0, 0};
  posture.degrees[sided(side, "foot")] = angles(tibia_from_foot);
  posture.degrees[sided(side, "toes")] = {in_degrees(foot.toe_pitch - foot.pitch), 0, 0};
}

}  // namespace mocapress::samples
