// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/bank/bank_writer.h"
#include "core/codec/format/own_memory.h"
#include "core/runtime/cooked_clip.h"

namespace mocapress {

/// A cooked clip that is in no bank yet.
struct ClipForBank {
  AlignedBytes clip;
  AlignedBytes tables;
  std::vector<std::byte> skeleton;  // the item of the bank

  const mcpr_cooked& cooked() const { return *reinterpret_cast<const mcpr_cooked*>(clip.data()); }
};

/// Cooks a .mcpr with its IK correction. Throws FormatError.
ClipForBank cook_for_bank(std::span<const std::byte> file);

/// A table of a bank. What names other tables is not copied as it is, and so never the same as what
/// names none.
struct BankTable {
  std::uint32_t offset;
  std::size_t bytes;
  bool names_tables;

  auto operator<=>(const BankTable& other) const = default;
};

/// Where tables of one bank are in another.
using CopiedTables = std::map<BankTable, runtime::TableOffset>;

/// The bytes of a clip in a bank, but for where its tables are: they are put among the bank's.
/// Where the clip is one of many of another bank, `copied` saves looking for what they share.
std::vector<std::byte> put_tables(const mcpr_cooked& clip, SharedTables& tables,
                                  CopiedTables* copied = nullptr);

}  // namespace mocapress
