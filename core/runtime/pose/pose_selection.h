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

/// The consecutive groups of a part that are needed.
struct GroupRange {
  std::uint16_t first = 0;  // within the part
  std::uint16_t count = 0;
};

/// Output places of a RotorGroup's joints. An unwanted joint is written to the place of a later
/// one, which then overwrites it.
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
  const mcpr_transform* rest = nullptr;  // their constant transforms; null: use the clip's table
  std::uint16_t* places;                 // for each joint of the clip: its place in the output, or
                                         // kNowhere
  mocapress::runtime::RotorPlaces* rotors;
  mocapress::runtime::GroupRange* parts;
  // Groups of columns that are needed.
  std::bitset<mocapress::runtime::kMostColumns / mocapress::runtime::kGroup> wanted;
  mcpr_selection(mocapress::runtime::Memory& memory, const mcpr_cooked& of);
  /// Selects joints; the array must outlive the selection.
  void select(const std::uint16_t* from, std::uint32_t count);
  /// Selects those of a list that another selection has, in its places; null: all of the clip's. A
  /// joint may be listed twice.
  void select_within(const mcpr_selection* whole, const std::uint16_t* from, std::uint32_t count);

 private:
  void find_rotors();
  void want_columns();
};
