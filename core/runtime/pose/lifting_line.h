// SPDX-License-Identifier: MIT
// One level of FORMAT.md's transform and its inverse, for a single signal in doubles.
#pragma once

#include "core/runtime/format/kinds.h"

namespace mocapress::runtime {

/// Splits `length` samples into even samples (the coarser signal) and details.
void split_line(Wavelet wavelet, int length, const double* samples, double* evens, double* details);

/// Inverts split_line(). Modifies `evens`.
void join_line(Wavelet wavelet, int length, double* evens, const double* details, double* samples);

}  // namespace mocapress::runtime
