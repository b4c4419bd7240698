// SPDX-License-Identifier: MIT
#include "resources/samples/generator/posture.h"

#include <array>
#include <string_view>

#include "core/motion/forward_kinematics.h"

namespace mocapress::samples {
namespace {

/// A share of the body's mass, `along` of the way from the first joint's origin to the second's.
struct Mass {
  std::string_view from;
  std::string_view to;
  double share;
  double along;
};

constexpr std::array<Mass, 4> kTrunkMasses = {{
    {"root", "lowerback", 0.142, 0},
    {"lowerback", "upperback", 0.139, 0.5},
    {"upperback", "lowerneck", 0.216, 0.5},
    {"lowerneck", "head", 0.081, 1.8},  // beyond its base: at the ear
}};

constexpr std::array<Mass, 6> kLimbMasses = {{
    {"femur", "tibia", 0.100, 0.433},
    {"tibia", "foot", 0.0465, 0.433},
    {"foot", "toes", 0.0145, 0.5},
    {"humerus", "radius", 0.028, 0.436},
    {"radius", "hand", 0.016, 0.430},
    {"hand", "fingers", 0.006, 0.5},
}};

}  // namespace

Eigen::RowVectorXd channels_of(const Skeleton& skeleton, const Posture& posture) {
  Eigen::RowVectorXd channels = Eigen::RowVectorXd::Zero(skeleton.channel_count());
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const ChannelKind kind = skeleton.channel_kind(c);
    const auto angles = posture.degrees.find(skeleton.joint(skeleton.channel_joint(c)).name);
    if (!is_rotation(kind))
      channels(c) = posture.root(axis_of(kind));
    else if (angles != posture.degrees.end())
      channels(c) = in_radians(angles->second(axis_of(kind)));
  }
  return channels;
}

Eigen::Matrix3d world_from_root(const Posture& posture) {
  const Eigen::Vector3d& degrees = posture.degrees.at("root");
  return axis_rotation(2, in_radians(degrees.z())) * axis_rotation(1, in_radians(degrees.y())) *
         axis_rotation(0, in_radians(degrees.x()));
}

Eigen::Vector3d centre_of_mass(const Skeleton& skeleton, const Eigen::RowVectorXd& frame) {
  Pose pose;
  compute_pose(skeleton, frame, pose);
  const auto origin = [&](const std::string& joint) {
    return pose.origin[static_cast<std::size_t>(skeleton.find(joint))];
  };
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double total = 0;
  const auto add = [&](const Mass& mass, const std::string& prefix) {
    const Eigen::Vector3d from = origin(prefix + std::string(mass.from));
    moment += mass.share * (from + mass.along * (origin(prefix + std::string(mass.to)) - from));
    total += mass.share;
  };
  for (const Mass& mass : kTrunkMasses) add(mass, "");
  for (const Mass& mass : kLimbMasses)
    for (const char* side : {"l", "r"}) add(mass, side);
  return moment / total;
}

}  // namespace mocapress::samples
