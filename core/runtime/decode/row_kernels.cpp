// SPDX-License-Identifier: MIT
#include "core/runtime/decode/row_kernels.h"

#include "core/runtime/format/bits.h"

#define MOCAPRESS_ROWS base_rows
#define MOCAPRESS_ROWS_TARGET
#include "core/runtime/decode/row_kernels_of.inc"

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace mocapress::runtime {
namespace {

#if defined(__SSE2__) || defined(_M_X64)
struct Sse2Vector {
  using Real = float;
  static constexpr std::ptrdiff_t kSize = 4;
  __m128 values;

  static Sse2Vector load(const float* from) { return {_mm_loadu_ps(from)}; }
  static Sse2Vector all(float value) { return {_mm_set1_ps(value)}; }
  void store(float* to) const { _mm_storeu_ps(to, values); }
};

inline Sse2Vector operator+(Sse2Vector a, Sse2Vector b) {
  return {_mm_add_ps(a.values, b.values)};
}
inline Sse2Vector operator-(Sse2Vector a, Sse2Vector b) {
  return {_mm_sub_ps(a.values, b.values)};
}
inline Sse2Vector operator*(Sse2Vector a, Sse2Vector b) {
  return {_mm_mul_ps(a.values, b.values)};
}
#endif

void unpack_all_plainly(const PackedRows& rows) {
  unpack_plainly(rows, 0, rows.groups, rows.packed);
}

#if defined(__SSE2__) || defined(_M_X64)
constexpr RowKernels kSse2Rows = {base_rows::lifting_of<Sse2Vector>(), unpack_all_plainly};
#endif

}  // namespace

const std::byte* unpack_plainly(const PackedRows& rows, int first_group, int end_group,
                                const std::byte* packed) {
  for (int g = first_group; g < end_group; ++g) {
    std::uint64_t bit = 0;
    for (int column = 8 * g; column < 8 * g + 8; ++column) {
      const int width = rows.widths[column];
      const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
      const auto bias = static_cast<std::int64_t>((mask + 1) >> 1 & mask);
      const float step = rows.steps[column] * rows.gain;
      for (int r = 0; r < rows.rows; ++r) {
        const std::uint64_t bits = bits_at(packed + r * rows.row_bytes, bit) & mask;
        const auto value = static_cast<std::int32_t>(static_cast<std::int64_t>(bits) - bias);
        rows.out[r * rows.stride + column] = static_cast<float>(value) * step;
      }
      bit += static_cast<std::uint64_t>(width);
    }
    packed += (bit + 7) / 8;
  }
  return packed;
}

const RowKernels kPlainRows = {base_rows::lifting_of<base_rows::PlainVectorOf<float>>(),
                               unpack_all_plainly};
const LiftingKernels<double> kWideRows = base_rows::lifting_of<base_rows::PlainVectorOf<double>>();

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

}  // namespace mocapress::runtime
