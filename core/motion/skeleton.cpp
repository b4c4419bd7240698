// SPDX-License-Identifier: MIT
#include "core/motion/skeleton.h"

#include <Eigen/Geometry>
#include <array>
#include <cassert>
#include <cmath>

namespace mocapress {

std::string_view short_name(ChannelKind kind) {
  constexpr std::array<std::string_view, kChannelKinds> kNames = {"tx", "ty", "tz",
                                                                  "rx", "ry", "rz"};
  return kNames[static_cast<std::size_t>(kind)];
}

Eigen::Matrix3d axis_rotation(int axis, double radians) {
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(next, next) = c;
  rotation(next, last) = -s;
  rotation(last, next) = s;
  rotation(last, last) = c;
  return rotation;
}

// Eigen's FromTwoVectors needs a singular value decomposition, which takes the compiler 5 s.
Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d across = from.cross(to);
  const double sine = across.norm();
  const double cosine = from.dot(to);
  const bool in_line = sine <= 1e-12 * std::abs(cosine);
  const Eigen::Vector3d axis = in_line ? from.unitOrthogonal() : Eigen::Vector3d(across / sine);
  return Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(sine, cosine), axis)).toRotationMatrix();
}

int Skeleton::add(Joint joint) {
  const int index = joint_count();
  assert(joint.parent < index);
  first_channels_.push_back(channel_count());
  channel_joints_.insert(channel_joints_.end(), joint.channels.size(), index);
  axes_.push_back(
      {joint.joint_from_axes * joint.before, joint.after * joint.joint_from_axes.transpose()});
  joints_.push_back(std::move(joint));
  return index;
}

ChannelKind Skeleton::channel_kind(int channel) const {
  const int owner = channel_joint(channel);
  return joint(owner).channels[channel - first_channel(owner)];
}

std::string Skeleton::channel_name(int channel) const {
  return joint(channel_joint(channel)).name + "." + std::string(short_name(channel_kind(channel)));
}

int Skeleton::find(const std::string& name) const {
  for (int j = 0; j < joint_count(); ++j)
    if (joint(j).name == name) return j;
  return -1;
}

std::vector<Segment> Skeleton::segments() const {
  std::vector<std::vector<Segment>> driven(joints_.size());
  const auto drive = [&](int joint, int child, const Eigen::Vector3d& end_in_joint) {
    driven[joint].push_back({joint, child, end_in_joint, end_in_joint.norm()});
  };
  for (int j = 0; j < joint_count(); ++j) {
    if (joint(j).parent >= 0) drive(joint(j).parent, j, joint(j).offset);
    if (joint(j).end_site) drive(j, -1, *joint(j).end_site);
  }
  std::vector<Segment> all;
  for (const auto& segments : driven) all.insert(all.end(), segments.begin(), segments.end());
  return all;
}

std::vector<double> Skeleton::driven_lengths() const {
  std::vector<double> lengths(joints_.size(), 0.0);
  for (const Segment& segment : segments()) lengths[segment.joint] += segment.length;
  return lengths;
}

}  // namespace mocapress
