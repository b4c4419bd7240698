// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/codec/format/result.h"
#include "core/runtime/cooked_clip.h"

namespace mocapress::runtime {

/// CRC-32 of all bytes after the checksum.
std::uint32_t checksum_of(const mcpr_cooked& clip);

/// Whether the head is a cooked clip's, of no more than so many bytes.
mcpr_result check_cooked_head(const mcpr_cooked& clip, std::size_t size);

/// Whether all of it is what sampling may rely on: nothing lies beyond the end, whatever the
/// numbers. After check_cooked_head().
mcpr_result check_cooked(const mcpr_cooked& clip);

}  // namespace mocapress::runtime
