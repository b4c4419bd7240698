// SPDX-License-Identifier: MIT
// One step of the transform of FORMAT.md on a single signal, forwards and backwards, in doubles.
#pragma once

#include "core/runtime/format/kinds.h"

namespace mocapress::runtime {

/// `length` samples into even samples, the coarser signal, and details.
void split_line(Wavelet wavelet, int length, const double* samples, double* evens, double* details);

/// And back. Changes `evens`.
void join_line(Wavelet wavelet, int length, double* evens, const double* details, double* samples);

}  // namespace mocapress::runtime
