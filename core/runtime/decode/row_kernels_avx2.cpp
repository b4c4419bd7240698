// SPDX-License-Identifier: MIT
// Everything below the headers is compiled for AVX2, and may be called only if the machine has it.
// FMA stays off: fused multiply-adds would give other bits than the other paths.
#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/processor/processor.h"

#ifdef MOCAPRESS_HAS_AVX2
#include <immintrin.h>

// MOCAPRESS_AVX2 is an attribute on each function instead of a pragma: GCC emits templates at the
// end of the file, where a pragma would affect those of other headers too.
#define MOCAPRESS_ROWS avx2_rows_of
#define MOCAPRESS_ROWS_TARGET MOCAPRESS_AVX2
#include "core/runtime/decode/row_kernels_of.inc"

namespace mocapress::runtime {
namespace {

struct Avx2Vector {
  using Real = float;
  static constexpr std::ptrdiff_t kSize = 8;
  __m256 values;

  MOCAPRESS_AVX2 static Avx2Vector load(const float* from) { return {_mm256_loadu_ps(from)}; }
  MOCAPRESS_AVX2 static Avx2Vector all(float value) { return {_mm256_set1_ps(value)}; }
  MOCAPRESS_AVX2 void store(float* to) const { _mm256_storeu_ps(to, values); }
};

MOCAPRESS_AVX2 Avx2Vector operator+(Avx2Vector a, Avx2Vector b) {
  return {_mm256_add_ps(a.values, b.values)};
}
MOCAPRESS_AVX2 Avx2Vector operator-(Avx2Vector a, Avx2Vector b) {
  return {_mm256_sub_ps(a.values, b.values)};
}
MOCAPRESS_AVX2 Avx2Vector operator*(Avx2Vector a, Avx2Vector b) {
  return {_mm256_mul_ps(a.values, b.values)};
}

constexpr int kWidestPacked = 25;  // bits; up to 7 bits of the same byte precede a number, and a
                                   // lane has 32

/// Masks and shifts that move the 8 numbers of a group to lanes of 32 bits. The lower four lanes
/// select bytes from the 16 at the start of the group; the upper four, from the 16 that begin with
/// the fifth number's byte.
struct PackedLanes {
  __m256i bytes;
  __m256i shifts;
  __m256i mask;
  __m256i bias;
  int fifth;  // byte in which the fifth number begins
  int size;   // bytes in the group
  bool fits;
};

MOCAPRESS_AVX2 PackedLanes lanes_of(const std::uint8_t* widths) {
  const __m256i one = _mm256_set1_epi32(1);
  const __m256i width =
      _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(widths)));
  // Prefix sums of the widths, in each half by itself: the end of each number, in bits from the
  // start of the half.
  __m256i end = _mm256_add_epi32(width, _mm256_slli_si256(width, 4));
  end = _mm256_add_epi32(end, _mm256_slli_si256(end, 8));
  const int half = _mm256_extract_epi32(end, 3);
  const int bits = half + _mm256_extract_epi32(end, 7);
  // In the upper half, bits count from the byte in which the fifth number begins.
  const __m256i offset =
      _mm256_inserti128_si256(_mm256_setzero_si256(), _mm_set1_epi32(half % 8), 1);
  const __m256i bit = _mm256_add_epi32(_mm256_sub_epi32(end, width), offset);
  const __m256i byte = _mm256_mullo_epi32(_mm256_srli_epi32(bit, 3), _mm256_set1_epi32(0x01010101));
  const __m256i size = _mm256_sllv_epi32(one, width);
  const __m256i mask = _mm256_sub_epi32(size, one);
  const __m256i wide = _mm256_cmpgt_epi32(width, _mm256_set1_epi32(kWidestPacked));
  return {.bytes = _mm256_add_epi32(byte, _mm256_set1_epi32(0x03020100)),
          .shifts = _mm256_and_si256(bit, _mm256_set1_epi32(7)),
          .mask = mask,
          .bias = _mm256_and_si256(_mm256_srli_epi32(size, 1), mask),
          .fifth = half / 8,
          .size = (bits + 7) / 8,
          .fits = _mm256_testz_si256(wide, wide) != 0};
}

MOCAPRESS_AVX2 void unpack_with_avx2(const PackedRows& rows) {
  const std::byte* packed = rows.packed;
  for (int g = 0; g < rows.groups; ++g) {
    const PackedLanes lanes = lanes_of(rows.widths + 8 * g);
    if (!lanes.fits) {
      packed = unpack_plainly(rows, g, g + 1, packed);
      continue;
    }
    const __m256 steps =
        _mm256_mul_ps(_mm256_loadu_ps(rows.steps + 8 * g), _mm256_set1_ps(rows.gain));
    const std::byte* row = packed;
    float* out = rows.out + 8 * g;
    for (int r = 0; r < rows.rows; ++r, row += rows.row_bytes, out += rows.stride) {
      const __m128i first = _mm_loadu_si128(reinterpret_cast<const __m128i*>(row));
      const __m128i last = _mm_loadu_si128(reinterpret_cast<const __m128i*>(row + lanes.fifth));
      const __m256i both = _mm256_inserti128_si256(_mm256_castsi128_si256(first), last, 1);
      const __m256i lifted =
          _mm256_srlv_epi32(_mm256_shuffle_epi8(both, lanes.bytes), lanes.shifts);
      const __m256i values = _mm256_sub_epi32(_mm256_and_si256(lifted, lanes.mask), lanes.bias);
      _mm256_storeu_ps(out, _mm256_mul_ps(_mm256_cvtepi32_ps(values), steps));
    }
    packed += lanes.size;
  }
}

}  // namespace

const RowKernels kAvx2Rows = {avx2_rows_of::lifting_of<Avx2Vector>(), unpack_with_avx2};

}  // namespace mocapress::runtime

#endif
