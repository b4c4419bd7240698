// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/pose/cooked_block.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/cooked_coefficients.h"
#include "core/runtime/pose/cooked_columns.h"

namespace mocapress::runtime {

/// Writes the rows of the loaded segment: the samples and dense rows of each part, then all
/// entries. `rows` and `entries` are null when measuring.
void lay_out_rows(CookedBlock& block, const CookedColumns& columns,
                  CookedCoefficients& coefficients, CookedRows* rows, CookedEntries* entries);

}  // namespace mocapress::runtime
