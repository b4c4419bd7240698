// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/format/bank.h"
#include "core/runtime/pose/cooked_check.h"

namespace mocapress::runtime {

/// Points `cooked` to a clip of a cooked bank. Checks only the clip's head.
mcpr_result cooked_clip_of(const mcpk_bank& bank, const BankEntry& entry,
                           const mcpr_cooked*& cooked);

/// Verifies everything that reading the bank relies on. Call check_bank_head() first. Without
/// `clips`, the bytes of the clips are not read, since they may be loaded later; check_clip() then
/// verifies each clip.
mcpr_result check_bank(const mcpk_bank& bank, bool clips);

mcpr_result check_clip(const mcpk_bank& bank, const BankEntry& entry);

}  // namespace mocapress::runtime
