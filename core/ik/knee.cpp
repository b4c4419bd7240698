// SPDX-License-Identifier: MIT
#include "core/ik/knee.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/motion/joint_rotation.h"

namespace mocapress {
namespace {

Eigen::Matrix3d local_rotation(const Skeleton& skeleton, int joint, const Clip& clip, int frame) {
  const auto channels = static_cast<Eigen::Index>(skeleton.joint(joint).channels.size());
  return joint_rotation(skeleton.joint(joint),
                        clip.channels.row(frame).segment(skeleton.first_channel(joint), channels));
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
