// SPDX-License-Identifier: MIT
// The kernels of value_prediction.h for AVX2. They compute the same integers as
// value_prediction.cpp.
#include "core/runtime/format/value_prediction.h"
#include "core/runtime/processor/processor.h"

#ifdef MOCAPRESS_HAS_AVX2
#include <immintrin.h>

namespace mocapress::runtime {
namespace avx2_prediction {
namespace {

MOCAPRESS_AVX2 inline __m256i eight_ints(const std::int32_t* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
MOCAPRESS_AVX2 inline __m256i four_longs(const std::int64_t* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
MOCAPRESS_AVX2 inline void store(__m256i vector, void* to) {
  _mm256_storeu_si256(static_cast<__m256i*>(to), vector);
}
MOCAPRESS_AVX2 inline __m256i eight_taps(const std::int16_t* from) {
  return _mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
}
MOCAPRESS_AVX2 inline __m256i four_as_longs(const std::int32_t* from) {
  return _mm256_cvtepi32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
}

/// Clears the upper half of each lane, so that numbers of 16 bits can be multiplied by a cheaper
/// instruction than _mm256_mullo_epi32.
MOCAPRESS_AVX2 inline __m256i low_halves(__m256i numbers) {
  return _mm256_and_si256(numbers, _mm256_set1_epi32(0xFFFF));
}

MOCAPRESS_AVX2 inline std::int32_t sum_of_ints(__m256i v) {
  __m128i sum = _mm_add_epi32(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4E));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xB1));
  return _mm_cvtsi128_si32(sum);
}

MOCAPRESS_AVX2 inline __m256i size_of_longs(__m256i v) {
  const __m256i sign = _mm256_cmpgt_epi64(_mm256_setzero_si256(), v);
  return _mm256_sub_epi64(_mm256_xor_si256(v, sign), sign);
}

constexpr int kLongs = SignalPrediction::kTaps / 4;  // vectors of 64-bit integers that hold kTaps
                                                     // numbers
constexpr int kInts = SignalPrediction::kTaps / 8;

MOCAPRESS_AVX2 int of_signal(const SignalPrediction& prediction, const std::int16_t* taps) {
  __m256i sums = _mm256_setzero_si256();
  for (int v = 0; v < kInts; ++v) {
    const __m256i weights = eight_ints(prediction.weights.data() + 8 * v);
    const __m256i tap = eight_taps(taps + 8 * v);
    sums = _mm256_add_epi64(sums, _mm256_mul_epi32(weights, tap));
    sums = _mm256_add_epi64(
        sums, _mm256_mul_epi32(_mm256_srli_epi64(weights, 32), _mm256_srli_epi64(tap, 32)));
  }
  const __m128i two =
      _mm_add_epi64(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
  const std::int64_t sum = _mm_cvtsi128_si64(two) + _mm_extract_epi64(two, 1);
  return static_cast<int>(std::clamp<std::int64_t>(sum >> 14, -2 * SignalPrediction::kFarthest,
                                                   2 * SignalPrediction::kFarthest));
}

/// Index of the largest error; the first of equal ones.
MOCAPRESS_AVX2 int most_in_error(const SignalPrediction& prediction) {
  __m256i sizes[kLongs];
  for (int v = 0; v < kLongs; ++v)
    sizes[v] = size_of_longs(four_longs(prediction.errors.data() + 4 * v));
  __m256i most = sizes[0];
  for (int v = 1; v < kLongs; ++v)
    most = _mm256_blendv_epi8(most, sizes[v], _mm256_cmpgt_epi64(sizes[v], most));
  __m256i other = _mm256_permute4x64_epi64(most, 0x4E);
  most = _mm256_blendv_epi8(most, other, _mm256_cmpgt_epi64(other, most));
  other = _mm256_permute4x64_epi64(most, 0xB1);
  most = _mm256_blendv_epi8(most, other, _mm256_cmpgt_epi64(other, most));
  unsigned found = 0;
  for (int v = 0; v < kLongs; ++v)
    found |= static_cast<unsigned>(
                 _mm256_movemask_pd(_mm256_castsi256_pd(_mm256_cmpeq_epi64(sizes[v], most))))
             << (4 * v);
  return std::countr_zero(found);
}

/// Makes up for an arithmetic shift of 64-bit lanes, which AVX2 lacks: kBias is added before a
/// logical shift, and kBias, shifted too, is subtracted after it.
constexpr std::int64_t kBias = std::int64_t{1} << 62;

MOCAPRESS_AVX2 void signal_follows(SignalPrediction& prediction, const std::int16_t* taps,
                                   int error) {
  constexpr int kTaps = SignalPrediction::kTaps;
  __m256i all[kInts];
  __m256i any = _mm256_setzero_si256();
  for (int v = 0; v < kInts; ++v) {
    const __m256i tap = eight_taps(taps + 8 * v);
    any = _mm256_or_si256(any, tap);
    all[v] = low_halves(tap);
  }
  if (_mm256_testz_si256(any, any) != 0) return;
  std::int32_t* row = prediction.products.data();
  for (int i = 0; i < kTaps; row += kTaps, ++i) {
    if (taps[i] == 0) continue;
    const __m256i tap = _mm256_set1_epi32(taps[i]);
    for (int v = 0; v < kInts; ++v)
      store(_mm256_add_epi32(eight_ints(row + 8 * v), _mm256_madd_epi16(all[v], tap)), row + 8 * v);
  }
  const __m256i by = _mm256_set1_epi64x(error);
  for (int v = 0; v < kLongs; ++v) {
    std::int64_t* const errors = prediction.errors.data() + 4 * v;
    const __m256i tap =
        _mm256_cvtepi16_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(taps + 4 * v)));
    store(_mm256_add_epi64(four_longs(errors), _mm256_mul_epi32(tap, by)), errors);
  }
  if (++prediction.seen == SignalPrediction::kMostSeen) prediction.halve();
  const __m256i most = _mm256_set1_epi64x(SignalPrediction::kMostLeft);
  const __m256i least = _mm256_set1_epi64x(-SignalPrediction::kMostLeft);
  for (int move = 0; move < SignalPrediction::kMoves; ++move) {
    const int tap = most_in_error(prediction);
    const std::int64_t moved = prediction.move_weight(tap);
    if (moved == 0) continue;
    const __m256i by_weight = _mm256_set1_epi64x(moved);
    for (int v = 0; v < kLongs; ++v) {
      std::int64_t* const errors = prediction.errors.data() + 4 * v;
      const __m256i change = _mm256_sub_epi64(
          _mm256_srli_epi64(
              _mm256_add_epi64(
                  _mm256_mul_epi32(four_as_longs(prediction.products.data() + kTaps * tap + 4 * v),
                                   by_weight),
                  _mm256_set1_epi64x(kBias)),
              14),
          _mm256_set1_epi64x(kBias >> 14));
      __m256i left = _mm256_sub_epi64(four_longs(errors), change);
      left = _mm256_blendv_epi8(left, most, _mm256_cmpgt_epi64(left, most));
      left = _mm256_blendv_epi8(left, least, _mm256_cmpgt_epi64(least, left));
      store(left, errors);
    }
  }
}

constexpr int kRestInts = RestPrediction::kTaps / 8;

MOCAPRESS_AVX2 int of_rest(const RestPrediction& rest, const RestPrediction::Taps& taps) {
  __m256i sums = _mm256_setzero_si256();
  for (int v = 0; v < kRestInts; ++v) {
    const __m256i weights =
        low_halves(_mm256_srai_epi32(eight_ints(rest.weights.data() + 8 * v), 8));
    sums = _mm256_add_epi32(sums, _mm256_madd_epi16(weights, eight_taps(taps.data() + 8 * v)));
  }
  return std::clamp(((1 << 11) + sum_of_ints(sums)) >> 12, -2 * SignalPrediction::kFarthest,
                    2 * SignalPrediction::kFarthest);
}

MOCAPRESS_AVX2 void rest_follows(RestPrediction& rest, const RestPrediction::Taps& taps,
                                 int error) {
  __m256i all[kRestInts];
  __m256i sums = _mm256_setzero_si256();
  for (int v = 0; v < kRestInts; ++v) {
    const __m256i tap = eight_taps(taps.data() + 8 * v);
    all[v] = low_halves(tap);
    sums = _mm256_add_epi32(sums, _mm256_madd_epi16(all[v], tap));
  }
  const __m256i step =
      _mm256_set1_epi32(RestPrediction::step_of(error, RestPrediction::kRidge + sum_of_ints(sums)));
  const __m256i most = _mm256_set1_epi32(RestPrediction::kMost);
  const __m256i least = _mm256_set1_epi32(-RestPrediction::kMost);
  for (int v = 0; v < kRestInts; ++v) {
    std::int32_t* const weights = rest.weights.data() + 8 * v;
    const __m256i moved = _mm256_add_epi32(eight_ints(weights), _mm256_madd_epi16(all[v], step));
    store(_mm256_max_epi32(_mm256_min_epi32(moved, most), least), weights);
  }
}

MOCAPRESS_AVX2 void normalise(const std::array<std::int32_t, RestPrediction::kTaps>& values,
                              std::int32_t inverse, RestPrediction::Taps& taps) {
  const __m256i by = _mm256_set1_epi32(inverse);
  const __m256i most = _mm256_set1_epi32(largest_normal(inverse));
  const __m256i least = _mm256_set1_epi32(-largest_normal(inverse));
  const __m128i farthest = _mm_set1_epi16(SignalPrediction::kFarthest);
  const __m128i nearest = _mm_set1_epi16(-SignalPrediction::kFarthest);
  for (int v = 0; v < kRestInts; ++v) {
    const __m256i clamped =
        _mm256_max_epi32(_mm256_min_epi32(eight_ints(values.data() + 8 * v), most), least);
    const __m256i scaled = _mm256_srai_epi32(_mm256_mullo_epi32(clamped, by), 10);
    const __m128i packed =
        _mm_packs_epi32(_mm256_castsi256_si128(scaled), _mm256_extracti128_si256(scaled, 1));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(taps.data() + 8 * v),
                     _mm_max_epi16(_mm_min_epi16(packed, farthest), nearest));
  }
}

}  // namespace
}  // namespace avx2_prediction

const PredictionKernels kAvx2Prediction = {
    avx2_prediction::of_signal, avx2_prediction::signal_follows, avx2_prediction::of_rest,
    avx2_prediction::rest_follows, avx2_prediction::normalise};

}  // namespace mocapress::runtime
#endif
