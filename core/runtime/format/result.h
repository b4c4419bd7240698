// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

inline constexpr mcpr_result kOk = {MCPR_OK, 0, "done"};

constexpr mcpr_result failure(mcpr_status status, std::size_t offset, const char* message) {
  return {status, offset, message};
}

constexpr bool failed(const mcpr_result& result) {
  return result.status != MCPR_OK;
}

/// Ends a call of the C interface: writes the report, unless `report` is null, and returns the
/// status.
constexpr mcpr_status tell(mcpr_result* report, const mcpr_result& result) {
  if (report != nullptr) *report = result;
  return result.status;
}

}  // namespace mocapress::runtime
