// SPDX-License-Identifier: MIT
#include "core/motion/additive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

constexpr int kFewestJoints = 6;  // turning joints that make a figure
constexpr double kFarFromRest = 45 * std::numbers::pi / 180;
constexpr double kAtTheOrigin = 0.1;  // share of the height of the legs
constexpr double kLegs = 0.5;         // least height below the root / extent above or beside it

/// True if kFewestJoints or more turn, and none far from rest. A joint turns by at most the sum of
/// its angles.
bool stays_near_rest(const Motion& motion) {
  int turning = 0;
  for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
    Eigen::VectorXd turned = Eigen::VectorXd::Zero(motion.clip.frames());
    const auto count = static_cast<int>(motion.skeleton.joint(j).channels.size());
    for (int c = motion.skeleton.first_channel(j);
         count > 0 && c < motion.skeleton.first_channel(j) + count; ++c)
      if (is_rotation(motion.skeleton.channel_kind(c)))
        turned += motion.clip.channels.col(c).cwiseAbs();
    if (turned.size() == 0 || turned.maxCoeff() > kFarFromRest) return false;
    turning += turned.maxCoeff() > 0;
  }
  return turning >= kFewestJoints;
}

}  // namespace

bool looks_additive(const Motion& motion) {
  if (motion.skeleton.joint_count() < kFewestJoints || !stays_near_rest(motion)) return false;
  const Pose rest = rest_pose(motion.skeleton);
  const Eigen::Vector3d root = rest.origin.front();
  double below = 0;
  double elsewhere = 0;
  for (const Eigen::Vector3d& joint : rest.origin) {
    below = std::max(below, root.y() - joint.y());
    elsewhere = std::max(
        {elsewhere, joint.y() - root.y(), std::hypot(joint.x() - root.x(), joint.z() - root.z())});
  }
  if (below < kLegs * elsewhere) return false;
  Pose pose;
  for (int t = 0; t < motion.clip.frames(); ++t) {
    compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
    if (pose.origin.front().norm() > kAtTheOrigin * below) return false;
  }
  return true;
}

}  // namespace mocapress
