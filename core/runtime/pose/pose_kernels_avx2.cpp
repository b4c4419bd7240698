// SPDX-License-Identifier: MIT
// Everything below the headers is compiled for AVX2, and may be called only if the machine has it.
// row_kernels_avx2.cpp explains how that is arranged.
#include "core/runtime/pose/pose_kernels.h"
#include "core/runtime/processor/processor.h"

#ifdef MOCAPRESS_HAS_AVX2
#include <immintrin.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/runtime/format/interpolation.h"

namespace mocapress::runtime::avx2_poses_of {
namespace {

/// A mask with all bits set in the lanes whose bit in `bits` is set.
MOCAPRESS_AVX2 inline __m256 lanes_of(unsigned bits) {
  const __m256i of_lane = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i all = _mm256_set1_epi32(static_cast<int>(bits));
  return _mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_and_si256(all, of_lane), of_lane));
}

MOCAPRESS_AVX2 inline __m256 sign_of(__m256 lanes) {
  return _mm256_and_ps(lanes, _mm256_set1_ps(-0.0F));
}

struct Floats {
  __m256 lanes;

  MOCAPRESS_AVX2 static Floats all(float value) { return {_mm256_set1_ps(value)}; }
  MOCAPRESS_AVX2 static Floats load(const float* from) { return {_mm256_loadu_ps(from)}; }
  MOCAPRESS_AVX2 static Floats of_floats(const std::byte* from) {
    return {_mm256_loadu_ps(reinterpret_cast<const float*>(from))};
  }
  MOCAPRESS_AVX2 static Floats of_upper_halves(const std::byte* from) {
    const __m128i halves = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
    return {_mm256_castsi256_ps(_mm256_slli_epi32(_mm256_cvtepu16_epi32(halves), 16))};
  }
  MOCAPRESS_AVX2 void store(float* to) const { _mm256_storeu_ps(to, lanes); }
  MOCAPRESS_AVX2 Floats only(unsigned bits) const { return {_mm256_and_ps(lanes, lanes_of(bits))}; }
  MOCAPRESS_AVX2 Floats negated_where(unsigned bits) const {
    return {_mm256_xor_ps(lanes, sign_of(lanes_of(bits)))};
  }
  MOCAPRESS_AVX2 Floats but_where(unsigned bits, const Floats& other) const {
    return {_mm256_blendv_ps(lanes, other.lanes, lanes_of(bits))};
  }
};

MOCAPRESS_AVX2 inline Floats operator+(const Floats& a, const Floats& b) {
  return {_mm256_add_ps(a.lanes, b.lanes)};
}
MOCAPRESS_AVX2 inline Floats operator-(const Floats& a, const Floats& b) {
  return {_mm256_sub_ps(a.lanes, b.lanes)};
}
MOCAPRESS_AVX2 inline Floats operator*(const Floats& a, const Floats& b) {
  return {_mm256_mul_ps(a.lanes, b.lanes)};
}

struct Wholes {
  __m256i lanes;

  MOCAPRESS_AVX2 static Wholes all(std::int32_t value) { return {_mm256_set1_epi32(value)}; }
  MOCAPRESS_AVX2 static Wholes load(const std::int32_t* from) {
    return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from))};
  }
  MOCAPRESS_AVX2 static Wholes of_words(const void* from) {
    return {_mm256_cvtepi16_epi32(_mm_loadu_si128(static_cast<const __m128i*>(from)))};
  }
  MOCAPRESS_AVX2 static Wholes of_bytes(const void* from) {
    return {_mm256_cvtepu8_epi32(_mm_loadl_epi64(static_cast<const __m128i*>(from)))};
  }
  /// Reads kSampleBytesBeyond bytes after the samples, too.
  MOCAPRESS_AVX2 static Wholes of_twelve_bits(const void* from) {
    const __m256i bytes =
        _mm256_broadcastsi128_si256(_mm_loadu_si128(static_cast<const __m128i*>(from)));
    // Puts two bytes into the upper half of each lane. -1 gives a zero byte.
    const __m256i places =
        _mm256_setr_epi8(-1, -1, 0, 4, -1, -1, 1, 5, -1, -1, 2, 6, -1, -1, 3, 7, -1, -1, 4, 8, -1,
                         -1, 5, 9, -1, -1, 6, 10, -1, -1, 7, 11);
    const __m256i shift = _mm256_setr_epi32(4, 4, 4, 4, 0, 0, 0, 0);
    return {_mm256_srai_epi32(_mm256_sllv_epi32(_mm256_shuffle_epi8(bytes, places), shift), 20)};
  }
  MOCAPRESS_AVX2 void store(std::int32_t* to) const {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), lanes);
  }
  MOCAPRESS_AVX2 void store_words(std::int16_t* to) const {
    const __m128i low = _mm256_castsi256_si128(lanes);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to),
                     _mm_packs_epi32(low, _mm256_extracti128_si256(lanes, 1)));
  }
  MOCAPRESS_AVX2 Wholes halved(int times) const {
    return {_mm256_sra_epi32(lanes, _mm_cvtsi32_si128(times))};
  }
  MOCAPRESS_AVX2 std::int32_t sum() const {
    __m128i sums = _mm_add_epi32(_mm256_castsi256_si128(lanes), _mm256_extracti128_si256(lanes, 1));
    sums = _mm_add_epi32(sums, _mm_shuffle_epi32(sums, 0x4E));
    return _mm_cvtsi128_si32(_mm_add_epi32(sums, _mm_shuffle_epi32(sums, 0xB1)));
  }
  MOCAPRESS_AVX2 Floats to_floats() const { return {_mm256_cvtepi32_ps(lanes)}; }
};

MOCAPRESS_AVX2 inline Wholes operator+(const Wholes& a, const Wholes& b) {
  return {_mm256_add_epi32(a.lanes, b.lanes)};
}
MOCAPRESS_AVX2 inline Wholes operator<<(const Wholes& a, int bits) {
  return {_mm256_slli_epi32(a.lanes, bits)};
}

/// Stores each weight at its row number modulo 16, and zeros elsewhere.
MOCAPRESS_AVX2 inline void place_entry_weights(const Wholes& whole, int first_row, int shift,
                                               std::int32_t* of_entry) {
  const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256i first = _mm256_set1_epi32(first_row & 7);
  const __m256i turned =  // rotated, so that row number modulo 8 is the lane
      _mm256_permutevar8x32_epi32(_mm256_sll_epi32(whole.lanes, _mm_cvtsi32_si128(shift)),
                                  _mm256_sub_epi32(lane, first));
  const __m256i is_next = _mm256_cmpgt_epi32(first, lane);  // lanes of rows in the other half of
                                                            // the 16
  const int half = first_row & 8;
  _mm256_store_si256(reinterpret_cast<__m256i*>(of_entry + half),
                     _mm256_andnot_si256(is_next, turned));
  _mm256_store_si256(reinterpret_cast<__m256i*>(of_entry + (half ^ 8)),
                     _mm256_and_si256(is_next, turned));
}

/// The weights of two rows: one in the lower half of each lane, one in the upper half.
struct PairWeights {
  __m256i lanes;

  MOCAPRESS_AVX2 static PairWeights load(const std::int16_t* from) {
    std::int32_t both;
    std::memcpy(&both, from, sizeof both);
    return {_mm256_set1_epi32(both)};
  }

  template <RowKind kKind>
  MOCAPRESS_AVX2 Wholes times(const std::byte* pair) const {
    if constexpr (kKind == RowKind::Nibbles) {
      const __m256i bytes =
          _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(pair)));
      const __m256i apart = _mm256_and_si256(_mm256_or_si256(bytes, _mm256_slli_epi32(bytes, 12)),
                                             _mm256_set1_epi32(0x000F000F));
      return {_mm256_madd_epi16(apart, lanes)};
    } else if constexpr (kKind == RowKind::Bytes) {
      const __m256i words =
          _mm256_cvtepi8_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(pair)));
      return {_mm256_madd_epi16(words, lanes)};
    } else {
      return {_mm256_madd_epi16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(pair)), lanes)};
    }
  }
};

struct RowPair {
  Wholes first;
  Wholes second;
};

/// Unpacks two rows of a bundle, which keep the bias of bias_of(). A bundle of crumbs has four
/// rows: `bit` is the position of the first of the two.
template <RowKind kKind>
MOCAPRESS_AVX2 MOCAPRESS_ALWAYS_INLINE RowPair pair_of(const std::byte* bundle, int bit) {
  if constexpr (kKind == RowKind::Crumbs || kKind == RowKind::Nibbles) {
    constexpr int kBits = kKind == RowKind::Crumbs ? 2 : 4;
    const __m256i mask = _mm256_set1_epi32((1 << kBits) - 1);
    __m256i bits = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(bundle)));
    if constexpr (kKind == RowKind::Crumbs) bits = _mm256_srl_epi32(bits, _mm_cvtsi32_si128(bit));
    return {{_mm256_and_si256(bits, mask)},
            {_mm256_and_si256(_mm256_srli_epi32(bits, kBits), mask)}};
  } else {
    const __m256i both =
        kKind == RowKind::Bytes
            ? _mm256_cvtepi8_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(bundle)))
            : _mm256_loadu_si256(reinterpret_cast<const __m256i*>(bundle));
    return {{_mm256_srai_epi32(_mm256_slli_epi32(both, 16), 16)}, {_mm256_srai_epi32(both, 16)}};
  }
}

MOCAPRESS_AVX2 inline Wholes bits_less(const Floats& floats, std::uint32_t less) {
  return {_mm256_sub_epi32(_mm256_castps_si256(floats.lanes),
                           _mm256_set1_epi32(static_cast<int>(less)))};
}

MOCAPRESS_AVX2 inline Wholes times_crumbs(const std::byte* rows, const std::int16_t* weights) {
  const __m256i bytes =
      _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(rows)));
  const __m256i spread = _mm256_or_si256(bytes, _mm256_slli_epi32(bytes, 14));
  const __m256i mask = _mm256_set1_epi32(0x00030003);
  const __m256i first = _mm256_and_si256(spread, mask);
  const __m256i last = _mm256_and_si256(_mm256_srli_epi32(spread, 4), mask);
  return {_mm256_add_epi32(_mm256_madd_epi16(first, PairWeights::load(weights).lanes),
                           _mm256_madd_epi16(last, PairWeights::load(weights + 2).lanes))};
}

struct Quadrants {
  __m256i lanes;

  MOCAPRESS_AVX2 explicit Quadrants(const Floats& quarters)
      : lanes(_mm256_castps_si256(quarters.lanes)) {}
  MOCAPRESS_AVX2 Floats sine(const Floats& s, const Floats& c) const {
    return {_mm256_xor_ps(_mm256_blendv_ps(s.lanes, c.lanes, odd()), minus(lanes))};
  }
  MOCAPRESS_AVX2 Floats cosine(const Floats& s, const Floats& c) const {
    return {_mm256_xor_ps(_mm256_blendv_ps(c.lanes, s.lanes, odd()),
                          minus(_mm256_add_epi32(lanes, _mm256_set1_epi32(1))))};
  }

 private:
  MOCAPRESS_AVX2 __m256 odd() const { return _mm256_castsi256_ps(_mm256_slli_epi32(lanes, 31)); }
  MOCAPRESS_AVX2 static __m256 minus(__m256i quarters) {
    return sign_of(_mm256_castsi256_ps(_mm256_slli_epi32(quarters, 30)));
  }
};

/// Adds eight entries; without kAll, only the first `count` of them.
template <bool kAll>
MOCAPRESS_AVX2 inline void add_eight(const std::uint16_t* entries, int count, __m256i low,
                                     __m256i high, std::int32_t* sums) {
  static_assert(kColumnBits + kRowBits == 11 && kEntriesBeyond == 7);
  const __m256i bits =
      _mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(entries)));
  const __m256i row = _mm256_srli_epi32(bits, kColumnBits);
  const __m256 weight =
      _mm256_blendv_ps(_mm256_castsi256_ps(_mm256_permutevar8x32_epi32(low, row)),
                       _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(high, row)),
                       _mm256_castsi256_ps(_mm256_slli_epi32(bits, 32 - kColumnBits - kRowBits)));
  __m256i value = _mm256_srai_epi32(bits, kColumnBits + kRowBits);
  if constexpr (!kAll) {
    const __m256i place = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    value = _mm256_and_si256(value, _mm256_cmpgt_epi32(_mm256_set1_epi32(count), place));
  }
  alignas(32) std::int32_t product[8];
  _mm256_store_si256(reinterpret_cast<__m256i*>(product),
                     _mm256_mullo_epi32(_mm256_castps_si256(weight), value));
#ifdef __GNUC__
  __asm__("" : "+m"(product));  // forces the product into memory: cheaper than extracting lanes
#endif
  const auto* const places = reinterpret_cast<const std::uint8_t*>(entries);
  MOCAPRESS_UNROLL(8)
  for (int k = 0; k < 8; ++k) sums[places[2 * k]] += product[k];
}

MOCAPRESS_AVX2 inline void add_run(const EntryRun& run, const std::int32_t* of_rows,
                                   std::int32_t* sums) {
  const auto* const weights = reinterpret_cast<const __m256i*>(of_rows);
  const __m256i low = _mm256_load_si256(weights);
  const __m256i high = _mm256_load_si256(weights + 1);
  int i = 0;
  for (; i + 8 <= run.count; i += 8) add_eight<true>(run.first + i, 8, low, high, sums);
  if (i < run.count) add_eight<false>(run.first + i, run.count - i, low, high, sums);
}

MOCAPRESS_AVX2 inline void put_quaternions(const std::uint16_t* places, int joints, const Floats& w,
                                           const Floats& x, const Floats& y, const Floats& z,
                                           float* out) {
  const __m256 wx_low = _mm256_unpacklo_ps(w.lanes, x.lanes);  // joints 0 1 4 5
  const __m256 wx_high = _mm256_unpackhi_ps(w.lanes, x.lanes);
  const __m256 yz_low = _mm256_unpacklo_ps(y.lanes, z.lanes);
  const __m256 yz_high = _mm256_unpackhi_ps(y.lanes, z.lanes);
  const __m256 both[4] = {
      // one joint, and the one four further on
      _mm256_shuffle_ps(wx_low, yz_low, 0x44), _mm256_shuffle_ps(wx_low, yz_low, 0xEE),
      _mm256_shuffle_ps(wx_high, yz_high, 0x44), _mm256_shuffle_ps(wx_high, yz_high, 0xEE)};
  if (joints == kGroup) {
    MOCAPRESS_UNROLL(4)
    for (int i = 0; i < 4; ++i) {
      _mm_storeu_ps(out + 8 * places[i], _mm256_castps256_ps128(both[i]));
      _mm_storeu_ps(out + 8 * places[i + 4], _mm256_extractf128_ps(both[i], 1));
    }
    return;
  }
  alignas(16) float one[kGroup][4];
  MOCAPRESS_UNROLL(4)
  for (int i = 0; i < 4; ++i) {
    _mm_store_ps(one[i], _mm256_castps256_ps128(both[i]));
    _mm_store_ps(one[i + 4], _mm256_extractf128_ps(both[i], 1));
  }
  for (int i = 0; i < joints; ++i) _mm_storeu_ps(out + 8 * places[i], _mm_load_ps(one[i]));
}

}  // namespace
}  // namespace mocapress::runtime::avx2_poses_of

#define MOCAPRESS_POSES avx2_poses_of
#define MOCAPRESS_POSES_TARGET MOCAPRESS_AVX2
// Inlined, because GCC 12 clears the upper halves of registers that a function returns in a struct.
#define MOCAPRESS_POSES_INLINE MOCAPRESS_AVX2 MOCAPRESS_ALWAYS_INLINE
#include "core/runtime/pose/pose_kernels_of.inc"

namespace mocapress::runtime {

const PoseKernels kAvx2Poses = {.set_band = avx2_poses_of::set_band,
                                .sum_entries = avx2_poses_of::sum_entries,
                                .make_columns = avx2_poses_of::make_columns,
                                .blend = avx2_poses_of::blend,
                                .lift = avx2_poses_of::lift,
                                .turn = avx2_poses_of::turn,
                                .turn_into = avx2_poses_of::turn_into};

}  // namespace mocapress::runtime

#endif
