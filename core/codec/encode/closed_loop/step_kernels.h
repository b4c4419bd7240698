// SPDX-License-Identifier: MIT
// The vectorised loops of the closed loop over a channel's coefficients, in the processor's best
// instruction set.
#pragma once

#include <bit>
#include <cmath>

#include "core/wavelet/lifting.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace mocapress {

/// Reduces each coefficient by `less` and cuts it to whole steps: its magnitude in steps plus
/// `added`, truncated.
void cut_to_steps(const double* coefficients, const float* less, int count, double per_unit,
                  double added, int* values);

/// differences[i] = values[i] * step - coefficients[i]
void find_differences(const int* values, int count, double step, const double* coefficients,
                      float* differences);

/// Calls visit(coefficient) for those of a band that are not zero or whose slope is steep: at least
/// `threshold` times their curvature.
template <typename Visit>
void visit_where(const Band& band, const int* values, const float* slopes, const float* curves,
                 float threshold, const Visit& visit) {
  int c = band.first;
  const int end = band.first + band.size;
#ifdef __SSE2__
  const __m128 no_sign = _mm_castsi128_ps(_mm_set1_epi32(0x7FFFFFFF));
  const __m128 least = _mm_set1_ps(threshold);
  const auto found_in_four = [&](int at) {
    const __m128 steep = _mm_cmpge_ps(_mm_and_ps(_mm_loadu_ps(slopes + at), no_sign),
                                      _mm_mul_ps(least, _mm_loadu_ps(curves + at)));
    const __m128i zero = _mm_cmpeq_epi32(
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(values + at)), _mm_setzero_si128());
    return _mm_or_ps(steep,
                     _mm_xor_ps(_mm_castsi128_ps(zero), _mm_castsi128_ps(_mm_set1_epi32(-1))));
  };
  for (; c + 4 <= end; c += 4)
    for (int found = _mm_movemask_ps(found_in_four(c)); found != 0; found &= found - 1)
      visit(c + std::countr_zero(static_cast<unsigned>(found)));
#endif
  for (; c < end; ++c)
    if (values[c] != 0 || std::abs(slopes[c]) >= threshold * curves[c]) visit(c);
}

}  // namespace mocapress
