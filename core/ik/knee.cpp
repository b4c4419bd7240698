// SPDX-License-Identifier: MIT
#include "core/ik/knee.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace mocapress {
namespace {

Eigen::Matrix3d local_rotation(const Skeleton& skeleton, int joint, const Clip& clip, int frame) {
  const Joint& of = skeleton.joint(joint);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < of.channels.size(); ++i)
    if (is_rotation(of.channels[i]))
      rotation *=
          axis_rotation(axis_of(of.channels[i]),
                        clip.channels(frame, skeleton.first_channel(joint) + static_cast<int>(i)));
  return rotation;
}

}  // namespace

int knee_of(const Effector& effector) {
  return effector.chain[std::min<std::size_t>(1, effector.chain.size() - 1)];
}

double fastest_knee(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                    const Clip& clip) {
  double fastest = 0;
  for (const Effector& effector : effectors) {
    Eigen::Matrix3d before;
    for (int t = 0; t < clip.frames(); ++t) {
      const Eigen::Matrix3d now = local_rotation(skeleton, knee_of(effector), clip, t);
      if (t > 0) fastest = std::max(fastest, Eigen::AngleAxisd(before.transpose() * now).angle());
      before = now;
    }
  }
  return fastest * clip.sample_rate_hz;
}

}  // namespace mocapress
