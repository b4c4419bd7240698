// SPDX-License-Identifier: MIT
// A subset of a cooked clip's joints: their places in the output, and the columns that they need.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// The groups of a part that are needed. They are consecutive.
struct GroupRange {
  std::uint16_t first = 0;  // number of the first group within the part
  std::uint16_t count = 0;
};

/// Places of a RotorGroup's joints in the output. A joint that is not selected is written to the
/// place of a later joint, which then overwrites it.
struct RotorPlaces {
  std::uint16_t place[kGroup] = {};
  std::uint16_t group = 0;
  std::uint16_t joints = 0;  // number of elements of `place` in use
};

/// True if all joints exist in the clip, without duplicates.
bool are_joints_of(const mcpr_cooked& clip, const std::uint16_t* joints, std::uint32_t count);

}  // namespace mocapress::runtime

struct mcpr_selection {
  static constexpr std::uint16_t kNowhere = 0xFFFF;

  const mcpr_cooked* clip = nullptr;
  const std::uint16_t* joints = nullptr;  // the selected joints, in output order
  std::uint32_t joint_count = 0;
  std::uint32_t rotor_groups = 0;
  const mcpr_transform* rest = nullptr;  // constant transforms of the selected joints; null: they
                                         // are in the clip's table
  std::uint16_t* places;                 // for each joint of the clip: its place in the output, or
                                         // kNowhere
  mocapress::runtime::RotorPlaces* rotors;
  mocapress::runtime::GroupRange* parts;
  // One bit per group of columns that is needed.
  std::bitset<mocapress::runtime::kMostColumns / mocapress::runtime::kGroup> wanted;
  mcpr_selection(mocapress::runtime::Memory& memory, const mcpr_cooked& of);
  /// Selects joints. The array must outlive the selection.
  void select(const std::uint16_t* from, std::uint32_t count);
  /// Selects the listed joints, as far as the selection `whole` has them, with their places there.
  /// If `whole` is null, it stands for all joints of the clip. A joint may be listed twice.
  void select_within(const mcpr_selection* whole, const std::uint16_t* from, std::uint32_t count);

 private:
  void find_rotors();
  void want_columns();
};
