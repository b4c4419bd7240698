// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/error.h"
#include "core/runtime/format/result.h"

namespace mocapress {

/// Throws FormatError if `result` is an error of the format's readers, which do not throw
/// themselves.
inline void require(const mcpr_result& result) {
  if (runtime::failed(result)) throw FormatError(result.offset, result.message);
}

}  // namespace mocapress
