// SPDX-License-Identifier: MIT
#include "core/runtime/ik/limb_planner.h"

#include <algorithm>

#include "core/runtime/format/format_limits.h"

namespace mocapress::runtime {

LimbPlanner::LimbPlanner(Memory& memory, int joints) : joint_count_(joints) {
  const auto count = static_cast<std::uint64_t>(joints);
  path_ = memory.take<std::uint32_t>(count);
  chain_ = memory.take<std::uint32_t>(count);
  link_of_ = memory.take<int>(count);
}

const char* LimbPlanner::plan(const JointModel* joints, const EffectorEnds* effectors, int count) {
  joints_ = joints;
  effectors_ = effectors;
  effector_count_ = count;
  std::fill_n(path_, joint_count_, 0);
  std::fill_n(chain_, joint_count_, 0);
  for (int e = 0; e < count; ++e)
    if (const char* const wrong = mark(e)) return wrong;
  group_effectors();
  for (int l = 0; l < limb_count_; ++l) {
    const LimbPlan plan = size(l);
    if (plan.effectors > kMostEffectorsOfLimb || plan.turns > kMostAngles ||
        plan.links > kMostLinks)
      return "a limb has more effectors, angles or joints than can be solved together";
  }
  return nullptr;
}

/// Marks the joints above an effector. Returns null, or an error as a sentence.
const char* LimbPlanner::mark(int effector) {
  const std::uint32_t bit = std::uint32_t{1} << effector;
  const EffectorEnds& ends = effectors_[effector];
  for (int other = 0; other < effector; ++other)
    if (effectors_[other].joint == ends.joint) return "a joint is an effector twice";
  if (ends.top >= ends.joint || !joints_[ends.top].turns())
    return "an effector's chain must begin at a joint above it that turns";
  bool in_chain = true;
  for (int j = ends.joint; j >= 0; j = joints_[j].parent) {
    path_[j] |= bit;
    if (j != ends.joint && in_chain && joints_[j].turns()) chain_[j] |= bit;
    if (j == ends.top) in_chain = false;
  }
  return in_chain ? "an effector's chain must begin at a joint above it that turns" : nullptr;
}

/// Adds the effectors one by one, each to the group with which it shares a joint; merges groups if
/// there are several. The order of the effectors in a group is the order of solving.
void LimbPlanner::group_effectors() {
  std::uint32_t shares[kMostEffectors] = {};
  for (int j = 0; j < joint_count_; ++j)
    for (int e = 0; e < effector_count_; ++e)
      if ((chain_[j] >> e & 1) != 0) shares[e] |= chain_[j];
  limb_count_ = 0;
  for (int e = 0; e < effector_count_; ++e) {
    Group joined;
    joined.effector[joined.count++] = static_cast<std::uint8_t>(e);
    joined.mask = std::uint32_t{1} << e;
    int kept = 0;
    for (int g = 0; g < limb_count_; ++g) {
      const Group group = groups_[g];
      if ((group.mask & shares[e]) == 0) {
        groups_[kept++] = group;
        continue;
      }
      std::copy_backward(joined.effector, joined.effector + joined.count,
                         joined.effector + joined.count + group.count);
      std::copy_n(group.effector, group.count, joined.effector);
      joined.count += group.count;
      joined.mask |= group.mask;
    }
    groups_[kept] = joined;
    limb_count_ = kept + 1;
  }
}

LimbPlan LimbPlanner::size(int limb) const {
  const Group& group = groups_[limb];
  LimbPlan plan;
  plan.effectors = group.count;
  for (int j = 0; j < joint_count_; ++j) {
    if ((path_[j] & group.mask) == 0) continue;
    ++plan.links;
    if ((chain_[j] & group.mask) == 0) continue;
    for (int c = 0; c < joints_[j].channels; ++c)
      plan.turns += is_rotation(joints_[j].kinds[c]) ? 1 : 0;
  }
  return plan;
}

LimbPlan LimbPlanner::lay_out(int limb, const Room& room) const {
  const Group& group = groups_[limb];
  LimbPlan plan;
  plan.effectors = group.count;
  plan.effector_numbers = room.effector_numbers;
  plan.effector_links = room.effector_links;
  plan.link = room.link;
  plan.turn = room.turn;
  for (int j = 0; j < joint_count_; ++j) {
    if ((path_[j] & group.mask) == 0) continue;
    const JointModel& joint = joints_[j];
    const int parent = joint.parent < 0 ? -1 : link_of_[joint.parent];
    room.link[plan.links] = {static_cast<std::uint16_t>(j), static_cast<std::int16_t>(parent)};
    link_of_[j] = plan.links++;
    if ((chain_[j] & group.mask) == 0) continue;
    std::uint8_t moves = 0;
    for (int i = 0; i < group.count; ++i)
      if ((chain_[j] >> group.effector[i] & 1) != 0)
        moves = static_cast<std::uint8_t>(moves | 1U << i);
    for (int c = 0; c < joint.channels; ++c)
      if (is_rotation(joint.kinds[c]))
        room.turn[plan.turns++] = {static_cast<std::uint16_t>(joint.first_channel + c),
                                   static_cast<std::uint16_t>(link_of_[j]),
                                   static_cast<std::uint8_t>(axis_of(joint.kinds[c])), moves};
  }
  for (int i = 0; i < group.count; ++i) {
    room.effector_numbers[i] = group.effector[i];
    room.effector_links[i] =
        static_cast<std::uint16_t>(link_of_[effectors_[group.effector[i]].joint]);
  }
  plan.is_two_bones = is_two_bones(plan);
  return plan;
}

bool LimbPlanner::is_two_bones(const LimbPlan& plan) const {
  if (plan.effectors != 1 || plan.turns != 4) return false;
  const LimbTurn* const turn = plan.turn;
  return turn[0].link == turn[2].link && turn[3].link != turn[2].link &&
         turn[0].axis != turn[1].axis && turn[1].axis != turn[2].axis &&
         turn[0].axis != turn[2].axis;
}

}  // namespace mocapress::runtime
