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

KneeSpeed::KneeSpeed(const Skeleton& skeleton, const std::vector<Effector>& effectors)
    : skeleton_(skeleton), effectors_(effectors) {}

void KneeSpeed::add(const Clip& frames) {
  const bool is_first = last_.empty();
  last_.resize(effectors_.size());
  for (std::size_t e = 0; e < effectors_.size(); ++e)
    for (int t = 0; t < frames.frames(); ++t) {
      const Eigen::Matrix3d now = local_rotation(skeleton_, knee_of(effectors_[e]), frames, t);
      if (t > 0 || !is_first) {
        const double angle = Eigen::AngleAxisd(last_[e].transpose() * now).angle();
        fastest_ = std::max(fastest_, angle * frames.sample_rate_hz);
      }
      last_[e] = now;
    }
}

double fastest_knee(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                    const Clip& clip) {
  KneeSpeed speed(skeleton, effectors);
  speed.add(clip);
  return speed.fastest();
}

}  // namespace mocapress
