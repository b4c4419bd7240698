// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bank/bank_writer.h"
#include "core/runtime/cooked_clip.h"

namespace mocapress {

/// A clip for a cooked bank.
struct BankedClip {
  std::vector<std::byte> bytes;     // but for where its tables are
  std::vector<std::byte> skeleton;  // the item of the bank
};

/// Cooks a .mcpr with its IK correction, and puts its tables among those of a bank. Throws
/// FormatError.
BankedClip cook_for_bank(std::span<const std::byte> file, SharedTables& tables);

/// A clip of a cooked bank for another one.
BankedClip copy_to_bank(const mcpr_cooked& clip, std::span<const std::byte> skeleton,
                        SharedTables& tables);

}  // namespace mocapress
