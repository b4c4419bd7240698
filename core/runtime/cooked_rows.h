// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/cooked_block.h"
#include "core/runtime/cooked_clip.h"
#include "core/runtime/cooked_coefficients.h"
#include "core/runtime/cooked_columns.h"

namespace mocapress::runtime {

/// Writes the rows of a part of the columns, of the segment that is loaded: samples, and of each
/// kept band dense rows and entries.
CookedRows lay_out_rows(CookedBlock& block, const CookedPart& part, const CookedColumns& columns,
                        CookedCoefficients& coefficients);

}  // namespace mocapress::runtime
