// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/format/bank.h"
#include "core/runtime/pose/cooked_check.h"

namespace mocapress::runtime {

/// Opens a clip of a cooked bank. Checks only its head.
mcpr_result cooked_clip_of(const mcpk_bank& bank, const BankEntry& entry,
                           const mcpr_cooked*& cooked);

/// Verifies everything that reading the bank relies on. Requires check_bank_head() first. Without
/// `clips`, their bytes need not be there: check_clip() verifies each once it is.
mcpr_result check_bank(const mcpk_bank& bank, bool clips);

mcpr_result check_clip(const mcpk_bank& bank, const BankEntry& entry);

}  // namespace mocapress::runtime
