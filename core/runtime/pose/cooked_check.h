// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/result.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// Computes the checksum that the head should have.
std::uint32_t checksum_of(const mcpr_cooked& clip);

/// Checks that the head is that of a cooked clip of at most `size` bytes.
mcpr_result check_cooked_head(const mcpr_cooked& clip, std::size_t size);

/// The range in which a clip's tables may lie.
struct TableRange {
  std::int64_t from = 0;    // the value that mcpr_cooked::tables must have
  std::uint64_t first = 0;  // this and the next: range of table offsets
  std::uint64_t end = 0;

  /// The range for a clip that is not in a bank.
  static TableRange within(const mcpr_cooked& clip) { return {0, sizeof clip, clip.bytes}; }
};

/// Verifies everything that sampling relies on, so that sampling never reads outside the clip. Call
/// check_cooked_head() first.
mcpr_result check_cooked(const mcpr_cooked& clip, const TableRange& tables);

}  // namespace mocapress::runtime
