// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/format/bank.h"
#include "core/runtime/pose/cooked_check.h"

namespace mocapress::runtime {

/// The clip of a cooked bank, of which only the head is looked at.
mcpr_result cooked_clip_of(const mcpk_bank& bank, const BankEntry& entry,
                           const mcpr_cooked*& cooked);

/// Whether all of a bank is what reading it may rely on. After check_bank_head().
mcpr_result check_bank(const mcpk_bank& bank);

}  // namespace mocapress::runtime
