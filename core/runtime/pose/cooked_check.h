// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/result.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// Computes the checksum that the head should have.
std::uint32_t checksum_of(const mcpr_cooked& clip);

/// Checks that the head is a cooked clip's, of at most `size` bytes.
mcpr_result check_cooked_head(const mcpr_cooked& clip, std::size_t size);

/// The range in which a clip's tables may lie.
struct TableRange {
  std::int64_t from = 0;    // as in mcpr_cooked::tables
  std::uint64_t first = 0;  // range of offsets from there
  std::uint64_t end = 0;

  /// The range for a clip that is not in a bank.
  static TableRange within(const mcpr_cooked& clip) { return {0, sizeof clip, clip.bytes}; }
};

/// Verifies everything that sampling relies on, so that it never reads outside the clip. Requires
/// check_cooked_head() first.
mcpr_result check_cooked(const mcpr_cooked& clip, const TableRange& tables);

}  // namespace mocapress::runtime
