// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/pose/cooked_block.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/cooked_coefficients.h"
#include "core/runtime/pose/cooked_columns.h"

namespace mocapress::runtime {

/// Writes the rows of the segment that is loaded: of each part samples and dense rows, then the
/// entries of all. Where only the size is measured, `rows` and `entries` are null.
void lay_out_rows(CookedBlock& block, const CookedColumns& columns,
                  CookedCoefficients& coefficients, CookedRows* rows, CookedEntries* entries);

}  // namespace mocapress::runtime
