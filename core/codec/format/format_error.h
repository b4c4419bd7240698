// SPDX-License-Identifier: MIT
#pragma once

#include <new>

#include "core/base/error.h"
#include "core/runtime/format/result.h"

namespace mocapress {

/// Throws FormatError if `result` is an error of the format's readers, which do not throw
/// themselves; std::bad_alloc if memory was short.
inline void require(const mcpr_result& result) {
  if (result.status == MCPR_NO_MEMORY) throw std::bad_alloc();
  if (runtime::failed(result)) throw FormatError(result.offset, result.message);
}

}  // namespace mocapress
