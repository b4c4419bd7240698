// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/runtime/ik/limb.h"

namespace mocapress::runtime {

/// A joint whose origin is corrected, and the joint at which its chain begins. All joints with
/// rotation channels, from the chain's first joint down to the effector's parent, may turn.
struct EffectorEnds {
  int joint;
  int top;
};

/// Groups effectors whose chains share joints into limbs, each of which can be solved by itself.
class LimbPlanner {
 public:
  LimbPlanner(Memory& memory, int joints);

  /// Plans the limbs of at most kMostEffectors effectors. Returns null, or an error as a sentence.
  const char* plan(const JointModel* joints, const EffectorEnds* effectors, int count);

  int limb_count() const { return limb_count_; }

  /// Numbers of a limb's effectors, in solving order.
  std::span<const std::uint8_t> effectors_of(int limb) const {
    return {groups_[limb].effector, static_cast<std::size_t>(groups_[limb].count)};
  }

  /// A plan with a limb's numbers of elements. Its pointers are not set.
  LimbPlan size(int limb) const;

  /// Memory for the arrays of a plan, which lay_out() fills.
  struct Room {
    std::uint16_t* effector_numbers;
    std::uint16_t* effector_links;
    LimbLink* link;
    LimbTurn* turn;
  };
  LimbPlan lay_out(int limb, const Room& room) const;

 private:
  struct Group {
    int count = 0;
    std::uint8_t effector[kMostEffectors] = {};
    std::uint32_t mask = 0;
  };

  const char* mark(int effector);
  void group_effectors();
  bool is_two_bones(const LimbPlan& plan) const;

  int joint_count_;
  std::uint32_t* path_;   // for each joint: the effectors at or below it, one bit each
  std::uint32_t* chain_;  // for each joint: the effectors in whose chains it turns, one bit each
  int* link_of_;          // for each joint: its link number in the limb that lay_out() works on
  const JointModel* joints_ = nullptr;
  const EffectorEnds* effectors_ = nullptr;
  int effector_count_ = 0;
  int limb_count_ = 0;
  Group groups_[kMostEffectors];
};

}  // namespace mocapress::runtime
