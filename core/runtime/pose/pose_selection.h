// SPDX-License-Identifier: MIT
// Some joints of a cooked clip: where each goes, and which columns they need.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// Groups of columns that are wanted of a part, one after the other.
struct GroupRange {
  std::uint16_t first = 0;  // in the part
  std::uint16_t count = 0;
};

/// Where the joints of a RotorGroup go. One that is not wanted goes where a later one does, which
/// then takes its place.
struct RotorPlaces {
  std::uint16_t place[kGroup] = {};
  std::uint16_t group = 0;
  std::uint16_t joints = 0;  // the first of `place` that are there
};

/// No joint twice, and all of them the clip's.
bool are_joints_of(const mcpr_cooked& clip, const std::uint16_t* joints, std::uint32_t count);

}  // namespace mocapress::runtime

struct mcpr_selection {
  static constexpr std::uint16_t kNowhere = 0xFFFF;

  const mcpr_cooked* clip = nullptr;
  const std::uint16_t* joints = nullptr;  // of the clip, in the order in which they come out
  std::uint32_t joint_count = 0;
  std::uint32_t rotor_groups = 0;
  const mcpr_transform* rest = nullptr;  // of these joints, what never changes; null: the clip's
  std::uint16_t* places;                 // where each joint of the clip goes, or kNowhere
  mocapress::runtime::RotorPlaces* rotors;
  mocapress::runtime::GroupRange* parts;
  std::bitset<mocapress::runtime::kMostColumns / mocapress::runtime::kGroup> wanted;  // groups

  /// Takes its arrays from memory, for any joints.
  mcpr_selection(mocapress::runtime::Memory& memory, const mcpr_cooked& of);
  /// These joints, which stay where they are.
  void select(const std::uint16_t* from, std::uint32_t count);

 private:
  void want_columns();
};
