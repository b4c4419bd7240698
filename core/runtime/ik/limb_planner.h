// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/runtime/ik/limb.h"

namespace mocapress::runtime {

/// A joint whose origin is to be moved, and the one above it from which down to its parent those
/// with rotation channels may turn for that.
struct EffectorEnds {
  int joint;
  int top;
};

/// Groups effectors whose chains share joints, so that each limb can be solved by itself.
class LimbPlanner {
 public:
  LimbPlanner(Memory& memory, int joints);

  /// Null, or what is wrong with these effectors (kMostEffectors at most) as a sentence.
  const char* plan(const JointModel* joints, const EffectorEnds* effectors, int count);

  int limb_count() const { return limb_count_; }

  /// The numbers of a limb's effectors, in the order in which they are solved.
  std::span<const std::uint8_t> effectors_of(int limb) const {
    return {groups_[limb].effector, static_cast<std::size_t>(groups_[limb].count)};
  }

  /// How large a limb is; what it points to is not set.
  LimbPlan size(int limb) const;

  /// Everything of a limb, in memory that has room for it.
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
  std::uint32_t* path_;   // of each joint: the effectors at or below it
  std::uint32_t* chain_;  // of each joint: the effectors it may turn for
  int* link_of_;          // of each joint, while a limb is laid out
  const JointModel* joints_ = nullptr;
  const EffectorEnds* effectors_ = nullptr;
  int effector_count_ = 0;
  int limb_count_ = 0;
  Group groups_[kMostEffectors];
};

}  // namespace mocapress::runtime
