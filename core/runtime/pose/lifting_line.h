// SPDX-License-Identifier: MIT
// One level of the transform in FORMAT.md, and its inverse, for a single signal in double
// precision.
#pragma once

#include "core/runtime/format/kinds.h"

namespace mocapress::runtime {

/// Splits `length` samples into even samples, which are the coarser signal, and details.
void split_line(Wavelet wavelet, int length, const double* samples, double* evens, double* details);

/// Inverts split_line(). Overwrites `evens`.
void join_line(Wavelet wavelet, int length, double* evens, const double* details, double* samples);

}  // namespace mocapress::runtime
