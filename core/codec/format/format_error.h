// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/error.h"
#include "core/runtime/format/result.h"

namespace mocapress {

/// Throws FormatError where reading failed: what the readers of the format say without exceptions.
inline void require(const mcpr_result& result) {
  if (runtime::failed(result)) throw FormatError(result.offset, result.message);
}

}  // namespace mocapress
