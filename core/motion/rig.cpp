// SPDX-License-Identifier: MIT
#include "core/motion/rig.h"

#include <algorithm>
#include <vector>

#include "core/base/fnv1a.h"

namespace mocapress {

std::string without_namespace(const std::string& joint) {
  const std::size_t colon = joint.rfind(':');
  return colon == std::string::npos ? joint : joint.substr(colon + 1);
}

std::string shared_namespace(const Skeleton& skeleton) {
  if (skeleton.joint_count() == 0) return {};
  const std::string& first = skeleton.joint(0).name;
  std::string shared = first.substr(0, first.rfind(':') + 1);  // empty if there is no colon
  const bool all = std::ranges::all_of(skeleton.joints(), [&](const Joint& joint) {
    return joint.name.starts_with(shared) && joint.name.size() > shared.size();
  });
  return all ? shared : std::string();
}

std::string rig_of(const Skeleton& skeleton) {
  std::vector<std::string> bones;
  for (const Joint& joint : skeleton.joints()) {
    bones.push_back(without_namespace(joint.name) + '\n');
    if (joint.parent >= 0) bones.back() += without_namespace(skeleton.joint(joint.parent).name);
  }
  std::ranges::sort(bones);  // files list joints in orders of their own
  Fnv1a hash;
  for (const std::string& bone : bones) hash.add(bone + '\0');
  return hash.text();
}

}  // namespace mocapress
