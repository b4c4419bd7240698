// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/bank/bank_writer.h"
#include "core/runtime/own_memory.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress {

/// A cooked clip that is not in a bank yet.
struct ClipForBank {
  AlignedBytes clip;
  AlignedBytes tables;
  std::vector<std::byte> skeleton;  // stored as an item of the bank
  std::uint64_t ik_bytes = 0;       // bytes of the IK correction in clip and tables

  const mcpr_cooked& cooked() const { return *reinterpret_cast<const mcpr_cooked*>(clip.data()); }
};

/// Options for cooking.
struct Cooking {
  bool apply_ik = true;
  /// The furthest that cooking the IK correction may move a joint at any frame, in cm; 0: not at
  /// all. Unset: the error that the clip's file states.
  std::optional<float> ik_error;
  /// Number of finest bands that stay details, as in mcpr_cook_options: with fewer, poses are
  /// faster and clips larger. 0: as suits memory.
  std::uint32_t detail_bands = 0;
};

/// Cooks a .mcpr. Throws FormatError.
ClipForBank cook_for_bank(std::span<const std::byte> file, const Cooking& cooking);

/// Returns the bytes of a clip for a bank, and puts its tables into `tables`. The distance from
/// clip to tables is set later, by BankWriter::finish().
std::vector<std::byte> put_tables(const mcpr_cooked& clip, SharedTables& tables);

}  // namespace mocapress
