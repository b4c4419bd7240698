// SPDX-License-Identifier: MIT
#include "row_kernels.h"

#include "row_kernels_of.h"

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace mocapress::decoder {
namespace {

struct PlainVector {
  static constexpr std::ptrdiff_t kSize = 1;
  float value;

  static PlainVector load(const float* from) { return {*from}; }
  static PlainVector all(float value) { return {value}; }
  void store(float* to) const { *to = value; }
  friend PlainVector operator+(PlainVector a, PlainVector b) { return {a.value + b.value}; }
  friend PlainVector operator-(PlainVector a, PlainVector b) { return {a.value - b.value}; }
  friend PlainVector operator*(PlainVector a, PlainVector b) { return {a.value * b.value}; }
};

#if defined(__SSE2__) || defined(_M_X64)
struct Sse2Vector {
  static constexpr std::ptrdiff_t kSize = 4;
  __m128 values;

  static Sse2Vector load(const float* from) { return {_mm_load_ps(from)}; }
  static Sse2Vector all(float value) { return {_mm_set1_ps(value)}; }
  void store(float* to) const { _mm_store_ps(to, values); }
  friend Sse2Vector operator+(Sse2Vector a, Sse2Vector b) {
    return {_mm_add_ps(a.values, b.values)};
  }
  friend Sse2Vector operator-(Sse2Vector a, Sse2Vector b) {
    return {_mm_sub_ps(a.values, b.values)};
  }
  friend Sse2Vector operator*(Sse2Vector a, Sse2Vector b) {
    return {_mm_mul_ps(a.values, b.values)};
  }
};

constexpr RowKernels kSse2Rows = kernels_of<Sse2Vector>();
#endif

}  // namespace

const RowKernels kPlainRows = kernels_of<PlainVector>();

const RowKernels* sse2_rows() {
#if defined(__SSE2__) || defined(_M_X64)
  return &kSse2Rows;
#else
  return nullptr;
#endif
}

const RowKernels* avx2_rows() {
#ifdef MOCAPRESS_DECODER_AVX2
  return __builtin_cpu_supports("avx2") != 0 ? &kAvx2Rows : nullptr;
#else
  return nullptr;
#endif
}

const RowKernels& best_rows() {
  if (const RowKernels* rows = avx2_rows()) return *rows;
  if (const RowKernels* rows = sse2_rows()) return *rows;
  return kPlainRows;
}

}  // namespace mocapress::decoder
