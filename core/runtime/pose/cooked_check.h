// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/result.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// As the head has it.
std::uint32_t checksum_of(const mcpr_cooked& clip);

/// Whether the head is a cooked clip's, of no more than so many bytes.
mcpr_result check_cooked_head(const mcpr_cooked& clip, std::size_t size);

/// Where the tables of a clip may lie.
struct TableRange {
  std::int64_t from = 0;    // as mcpr_cooked::tables
  std::uint64_t first = 0;  // bytes from there
  std::uint64_t end = 0;

  /// Of a clip by itself.
  static TableRange within(const mcpr_cooked& clip) { return {0, sizeof clip, clip.bytes}; }
};

/// Whether all of it is what sampling may rely on: nothing lies beyond the end, whatever the
/// numbers. After check_cooked_head().
mcpr_result check_cooked(const mcpr_cooked& clip, const TableRange& tables);

}  // namespace mocapress::runtime
