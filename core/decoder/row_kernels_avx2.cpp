// SPDX-License-Identifier: MIT
// Everything below the headers is compiled for AVX2 and must only be called where the machine has
// it. Without FMA: a contraction would give other bits than the other paths.
#include "row_kernels.h"

#ifdef MOCAPRESS_DECODER_AVX2
#include <immintrin.h>

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")  // to the end of the file, where GCC makes the templates' code
#endif

#include "row_kernels_of.h"

namespace mocapress::decoder {
namespace {

struct Avx2Vector {
  static constexpr std::ptrdiff_t kSize = 8;
  __m256 values;

  static Avx2Vector load(const float* from) { return {_mm256_load_ps(from)}; }
  static Avx2Vector all(float value) { return {_mm256_set1_ps(value)}; }
  void store(float* to) const { _mm256_store_ps(to, values); }
};

// Not friends in the class: GCC 12 would compile those without AVX2.
Avx2Vector operator+(Avx2Vector a, Avx2Vector b) {
  return {_mm256_add_ps(a.values, b.values)};
}
Avx2Vector operator-(Avx2Vector a, Avx2Vector b) {
  return {_mm256_sub_ps(a.values, b.values)};
}
Avx2Vector operator*(Avx2Vector a, Avx2Vector b) {
  return {_mm256_mul_ps(a.values, b.values)};
}

}  // namespace

const RowKernels kAvx2Rows = kernels_of<Avx2Vector>();

}  // namespace mocapress::decoder

#if defined(__clang__)
#pragma clang attribute pop
#endif

#endif
