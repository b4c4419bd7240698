// SPDX-License-Identifier: MIT
#include "core/ik/effector.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

bool is_below(const Skeleton& skeleton, int joint, int ancestor) {
  while (joint > ancestor) joint = skeleton.joint(joint).parent;
  return joint == ancestor;
}

}  // namespace

std::vector<int> limb_above(const Skeleton& skeleton, int joint) {
  constexpr double kAboutAsFar = 0.6;
  const Pose pose = rest_pose(skeleton);
  const auto distance = [&](int a, int b) { return (pose.origin[a] - pose.origin[b]).norm(); };
  std::vector<int> limb;
  int inner = joint;  // the child of j on the way to `joint`
  for (int j = skeleton.joint(joint).parent; j >= 0 && skeleton.joint(j).parent >= 0;
       inner = j, j = skeleton.joint(j).parent) {
    const double own_reach = distance(j, joint);
    double other_reach = 0;
    for (int k = j + 1; k < skeleton.joint_count(); ++k)
      if (is_below(skeleton, k, j) && !is_below(skeleton, k, inner))
        other_reach = std::max(other_reach, distance(j, k));
    if (!limb.empty() && other_reach > kAboutAsFar * own_reach) break;
    limb.push_back(j);
  }
  return limb;
}

Effector effector_of_limb(const Skeleton& skeleton, int joint) {
  Effector effector{joint, limb_above(skeleton, joint)};
  std::erase_if(effector.chain, [&](int j) { return !turns(skeleton.joint(j)); });
  std::ranges::reverse(effector.chain);
  return effector;
}

Effector effector_at(const Skeleton& skeleton, int joint) {
  Effector effector = effector_of_limb(skeleton, joint);
  if (effector.chain.empty())
    throw Error("no joint above " + shortened(skeleton.joint(joint).name) + " can turn to move it");
  return effector;
}

Effector effector_between(const Skeleton& skeleton, int top, int joint) {
  Effector effector{joint, {}};
  for (int j = skeleton.joint(joint).parent; j >= top && j >= 0; j = skeleton.joint(j).parent)
    if (turns(skeleton.joint(j))) effector.chain.push_back(j);
  if (effector.chain.empty() || effector.chain.back() != top)
    throw Error("a chain of joints that ends at " + skeleton.joint(joint).name +
                " does not begin at a joint above it that can turn");
  std::ranges::reverse(effector.chain);
  return effector;
}

}  // namespace mocapress
