// SPDX-License-Identifier: MIT
#include "core/motion/difference.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/rotation_form.h"

namespace mocapress {
namespace {

constexpr double kOffsetTolerance = 0.01;  // cm
constexpr double kAxesTolerance = 1e-4;

auto count_rotations(const Joint& joint) {
  return std::ranges::count_if(joint.channels, is_rotation);
}

/// The skeleton with three rotation channels about different axes on each joint that has two or
/// more rotation channels.
Skeleton freely_turning(const Skeleton& skeleton) {
  Skeleton result;
  for (Joint joint : skeleton.joints()) {
    if (count_rotations(joint) > 1 && !turns_freely(joint)) {
      std::erase_if(joint.channels, is_rotation);
      for (const int axis : {0, 1, 2}) joint.channels.push_back(rotation_about(axis));
    }
    result.add(std::move(joint));
  }
  result.set_skin(skeleton.skin());
  return result;
}

void require_joints_of(const Motion& base, const Motion& motion) {
  const Skeleton& a = base.skeleton;
  const Skeleton& b = motion.skeleton;
  if (a.joint_count() != b.joint_count())
    throw Error("the base has " + std::to_string(a.joint_count()) + " joints, the clip " +
                std::to_string(b.joint_count()));
  for (int j = 0; j < b.joint_count(); ++j) {
    const Joint& of_base = a.joint(j);
    const Joint& joint = b.joint(j);
    if (of_base.name != joint.name || of_base.parent != joint.parent ||
        of_base.channels != joint.channels ||
        (of_base.offset - joint.offset).norm() > kOffsetTolerance ||
        (of_base.joint_from_axes - joint.joint_from_axes).norm() > kAxesTolerance)
      throw Error("the joint " + joint.name + " of the clip is not the base's");
  }
  if (base.clip.frames() != 1 && base.clip.frames() != motion.clip.frames())
    throw Error("the base has " + std::to_string(base.clip.frames()) + " frames, the clip " +
                std::to_string(motion.clip.frames()) +
                ": it is one pose, or has as many frames as the clip");
}

/// The values of a joint's channels in a frame. A motion of one frame has the same values in all.
Eigen::RowVectorXd values_of(const Motion& motion, int joint, int frame) {
  return motion.clip.channels.block(
      motion.clip.frames() == 1 ? 0 : frame, motion.skeleton.first_channel(joint), 1,
      static_cast<Eigen::Index>(motion.skeleton.joint(joint).channels.size()));
}

double sum_of_kind(const Joint& joint, const Eigen::RowVectorXd& values, ChannelKind kind) {
  double sum = 0;
  for (std::size_t c = 0; c < joint.channels.size(); ++c)
    if (joint.channels[c] == kind) sum += values(c);
  return sum;
}

/// Adds the base to a motion joint by joint (`sign` 1), or subtracts it (-1).
Motion combined(const Motion& base, const Motion& motion, int sign) {
  Motion result{freely_turning(motion.skeleton), {motion.clip.sample_rate_hz, {}}};
  result.clip.channels.setZero(motion.clip.frames(), result.skeleton.channel_count());
  parallel_for(0, result.skeleton.joint_count(), [&](int j) {
    const Joint& of_base = base.skeleton.joint(j);
    const Joint& of_motion = motion.skeleton.joint(j);
    const Joint& joint = result.skeleton.joint(j);
    const auto count = static_cast<Eigen::Index>(joint.channels.size());
    const bool turns_freely = count_rotations(joint) > 1;
    Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(count);
    for (int t = 0; t < motion.clip.frames(); ++t) {
      const Eigen::RowVectorXd there = values_of(base, j, t);
      const Eigen::RowVectorXd own = values_of(motion, j, t);
      for (Eigen::Index c = 0; c < count; ++c) {
        const ChannelKind kind = joint.channels[c];
        if (!is_rotation(kind) || !turns_freely)
          values(c) = sum_of_kind(of_motion, own, kind) + sign * sum_of_kind(of_base, there, kind);
      }
      if (turns_freely) {
        Eigen::Matrix3d turn = joint_rotation(of_base, there);
        if (sign < 0) turn.transposeInPlace();
        turn_joint(joint, joint_rotation(of_motion, own) * turn, values);
      }
      result.clip.channels.block(t, result.skeleton.first_channel(j), 1, count) = values;
    }
  });
  return result;
}

/// The points of a skin, with places in each joint's frame turned by `turns`.
std::shared_ptr<const SkinPoints> turned(const std::shared_ptr<const SkinPoints>& skin,
                                         const std::vector<Eigen::Matrix3d>& turns) {
  if (skin == nullptr) return skin;
  auto result = std::make_shared<SkinPoints>(*skin);
  for (SkinPoint& point : *result)
    for (SkinPointShare& share : point) share.in_joint = turns[share.joint] * share.in_joint;
  return result;
}

}  // namespace

Motion difference_to(const Motion& base, const Motion& motion) {
  require_joints_of(base, motion);
  return combined(base, motion, -1);
}

Motion sum_of(const Motion& base, const Motion& difference) {
  return combined(base, difference, 1);
}

// Each joint's frame is turned by the joint's rotation in the world in the base, so that at rest it
// is parallel to the world's. A difference D of the joint's rotation then becomes W D W^-1, where W
// is the parent's rotation in the world: the same channels about other axes.
Motion on_base_pose(const Motion& base, const Motion& difference) {
  Pose pose;
  compute_pose(base.skeleton, base.clip.channels.row(0), pose);
  Motion result{{}, difference.clip};
  for (int j = 0; j < difference.skeleton.joint_count(); ++j) {
    Joint joint = difference.skeleton.joint(j);
    const auto parent = static_cast<std::size_t>(joint.parent);
    joint.offset = pose.origin[j];
    if (joint.parent >= 0) {
      joint.offset -= pose.origin[parent];
      joint.joint_from_axes = pose.world_from_joint[parent] * joint.joint_from_axes;
    }
    if (joint.end_site) *joint.end_site = pose.world_from_joint[j] * *joint.end_site;
    result.skeleton.add(std::move(joint));
  }
  result.skeleton.set_skin(turned(difference.skeleton.skin(), pose.world_from_joint));
  return result;
}

}  // namespace mocapress
