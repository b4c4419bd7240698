// SPDX-License-Identifier: MIT
#include "core/motion/skeleton.h"

#include <cassert>

namespace mocapress {

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
  return joint(owner).channels[static_cast<std::size_t>(channel - first_channel(owner))];
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
    driven[static_cast<std::size_t>(joint)].push_back(
        {joint, child, end_in_joint, end_in_joint.norm()});
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
  for (const Segment& segment : segments())
    lengths[static_cast<std::size_t>(segment.joint)] += segment.length;
  return lengths;
}

}  // namespace mocapress
