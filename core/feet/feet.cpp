// SPDX-License-Identifier: MIT
#include "core/feet/feet.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

std::vector<int> children_of(const Skeleton& skeleton, int joint) {
  std::vector<int> children;
  for (int j = joint + 1; j < skeleton.joint_count(); ++j)
    if (skeleton.joint(j).parent == joint) children.push_back(j);
  return children;
}

bool is_below(const Skeleton& skeleton, int joint, int ancestor) {
  while (joint > ancestor) joint = skeleton.joint(joint).parent;
  return joint == ancestor;
}

std::string lower(const std::string& text) {
  std::string result = text;
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool contains_any(const std::string& text, std::initializer_list<const char*> words) {
  return std::ranges::any_of(
      words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

bool names_a_foot(const std::string& name) {
  return contains_any(lower(name), {"foot", "ankle"});
}

bool names_a_ball(const std::string& name) {
  return contains_any(lower(name), {"toe", "ball", "forefoot"});
}

/// Feet by name: in each limb the outermost joint named as a foot but not as a toe. A child of it
/// that is named as a toe or ball takes its place; of several, the first with the shortest name. So
/// LeftToe goes before LeftToeTwist, and both feet get the same joint in any order of children.
std::vector<int> feet_by_name(const Skeleton& skeleton) {
  std::vector<int> feet;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    if (!names_a_foot(skeleton.joint(j).name) || names_a_ball(skeleton.joint(j).name)) continue;
    std::vector<int> children = children_of(skeleton, j);
    const bool another_below = std::ranges::any_of(children, [&](int child) {
      return names_a_foot(skeleton.joint(child).name) && !names_a_ball(skeleton.joint(child).name);
    });
    if (another_below) continue;
    std::erase_if(children, [&](int child) { return !names_a_ball(skeleton.joint(child).name); });
    const auto ball = std::ranges::min_element(
        children, {}, [&](int child) { return skeleton.joint(child).name.size(); });
    feet.push_back(ball != children.end() ? *ball : j);
  }
  return feet;
}

/// Feet by topology: among limbs of at least three joints, the outermost joints of the two that
/// hang lowest at rest.
std::vector<int> feet_by_topology(const Skeleton& skeleton) {
  constexpr std::size_t kLegJoints = 3;
  const Pose pose = rest_pose(skeleton);
  struct Leaf {
    double height;
    int joint;
  };
  std::vector<Leaf> leaves;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (children_of(skeleton, j).empty() && limb_above(skeleton, j).size() >= kLegJoints)
      leaves.push_back({pose.origin[j].y(), j});
  std::ranges::stable_sort(leaves,
                           [](const Leaf& a, const Leaf& b) { return a.height < b.height; });
  std::vector<int> feet;
  for (const Leaf& leaf : leaves) {
    const int hip = limb_above(skeleton, leaf.joint).back();
    const bool taken =
        std::ranges::any_of(feet, [&](int foot) { return is_below(skeleton, foot, hip); });
    if (!taken && feet.size() < 2) feet.push_back(leaf.joint);
  }
  std::ranges::sort(feet);
  return feet;
}

}  // namespace

std::vector<Effector> find_feet(const Skeleton& skeleton) {
  std::vector<int> feet = feet_by_name(skeleton);
  if (feet.empty()) feet = feet_by_topology(skeleton);
  std::vector<Effector> effectors;
  for (const int foot : feet) {
    Effector effector = effector_of_limb(skeleton, foot);
    if (!effector.chain.empty()) effectors.push_back(std::move(effector));
  }
  return effectors;
}

}  // namespace mocapress
