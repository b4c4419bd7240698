// SPDX-License-Identifier: MIT
// The types of four.h with SSE2, which every 64-bit x86 processor has.
#pragma once

#include <emmintrin.h>

namespace mocapress::runtime {

struct Floats4 {
  using Real = float;
  static constexpr std::ptrdiff_t kSize = 4;
  __m128 lanes;

  static Floats4 all(float value) { return {_mm_set1_ps(value)}; }
  static Floats4 load(const float* from) { return {_mm_loadu_ps(from)}; }
  void store(float* to) const { _mm_storeu_ps(to, lanes); }
};

inline Floats4 operator+(Floats4 a, Floats4 b) {
  return {_mm_add_ps(a.lanes, b.lanes)};
}
inline Floats4 operator-(Floats4 a, Floats4 b) {
  return {_mm_sub_ps(a.lanes, b.lanes)};
}
inline Floats4 operator*(Floats4 a, Floats4 b) {
  return {_mm_mul_ps(a.lanes, b.lanes)};
}
inline Floats4 operator/(Floats4 a, Floats4 b) {
  return {_mm_div_ps(a.lanes, b.lanes)};
}
inline Floats4 square_root(Floats4 a) {
  return {_mm_sqrt_ps(a.lanes)};
}

struct Ints4 {
  __m128i lanes;

  static Ints4 all(std::int32_t value) { return {_mm_set1_epi32(value)}; }
  static Ints4 load(const std::int32_t* from) {
    return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))};
  }
  void store(std::int32_t* to) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(to), lanes); }
  Floats4 to_floats() const { return {_mm_cvtepi32_ps(lanes)}; }
  std::int32_t sum() const {
    const __m128i two = _mm_add_epi32(lanes, _mm_shuffle_epi32(lanes, 0x4E));
    return _mm_cvtsi128_si32(_mm_add_epi32(two, _mm_shuffle_epi32(two, 0xB1)));
  }
};

inline Ints4 operator+(Ints4 a, Ints4 b) {
  return {_mm_add_epi32(a.lanes, b.lanes)};
}
inline Ints4 operator-(Ints4 a, Ints4 b) {
  return {_mm_sub_epi32(a.lanes, b.lanes)};
}
inline Ints4 operator&(Ints4 a, Ints4 b) {
  return {_mm_and_si128(a.lanes, b.lanes)};
}
inline Ints4 operator^(Ints4 a, Ints4 b) {
  return {_mm_xor_si128(a.lanes, b.lanes)};
}
inline Ints4 operator<<(Ints4 a, int bits) {
  return {_mm_slli_epi32(a.lanes, bits)};
}
inline Ints4 operator>>(Ints4 a, int bits) {
  return {_mm_srai_epi32(a.lanes, bits)};
}
inline Ints4 bits_of(Floats4 a) {
  return {_mm_castps_si128(a.lanes)};
}
inline Floats4 floats_of(Ints4 bits) {
  return {_mm_castsi128_ps(bits.lanes)};
}

/// A mask: all bits are set in the lanes where a has every bit of b.
inline Ints4 has_all(Ints4 a, Ints4 b) {
  return {_mm_cmpeq_epi32(_mm_and_si128(a.lanes, b.lanes), b.lanes)};
}

/// Takes b in lanes where all bits of `lanes` are set, and a where no bit is.
inline Ints4 either(Ints4 lanes, Ints4 a, Ints4 b) {
  return {
      _mm_or_si128(_mm_andnot_si128(lanes.lanes, a.lanes), _mm_and_si128(lanes.lanes, b.lanes))};
}

struct Words8 {
  __m128i lanes;

  static Words8 load(const void* from) {
    return {_mm_loadu_si128(static_cast<const __m128i*>(from))};
  }
  static Words8 of_pairs(Ints4 pairs) { return {pairs.lanes}; }
  /// Loads eight unsigned bytes.
  static Words8 of_bytes(const void* from) {
    const __m128i bytes = _mm_loadl_epi64(static_cast<const __m128i*>(from));
    return {_mm_unpacklo_epi8(bytes, _mm_setzero_si128())};
  }
  /// Loads eight signed bytes.
  static Words8 of_signed_bytes(const void* from) {
    const __m128i bytes = _mm_loadl_epi64(static_cast<const __m128i*>(from));
    return {_mm_srai_epi16(_mm_unpacklo_epi8(bytes, bytes), 8)};
  }
  /// Makes words from bytes: the lower halves are the bytes of `low`, the upper halves those of
  /// `high`.
  static Words8 of_halves(const std::byte* low, const std::byte* high) {
    return {_mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(low)),
                              _mm_loadl_epi64(reinterpret_cast<const __m128i*>(high)))};
  }
  /// The numbers of two vectors as words. Each must fit into 16 bits.
  static Words8 packed(Ints4 low, Ints4 high) { return {_mm_packs_epi32(low.lanes, high.lanes)}; }
  void store(std::int16_t* to) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(to), lanes); }

  /// The first four words, or the last four, as 32-bit integers: signed, or unsigned.
  Ints4 low() const { return {_mm_srai_epi32(_mm_unpacklo_epi16(lanes, lanes), 16)}; }
  Ints4 high() const { return {_mm_srai_epi32(_mm_unpackhi_epi16(lanes, lanes), 16)}; }
  Ints4 unsigned_low() const { return {_mm_unpacklo_epi16(lanes, _mm_setzero_si128())}; }
  Ints4 unsigned_high() const { return {_mm_unpackhi_epi16(lanes, _mm_setzero_si128())}; }

  /// Reads each two adjacent words as one 32-bit number, whose lower half is the first word.
  Ints4 pairs() const { return {lanes}; }
  Words8 masked(std::int16_t mask) const { return {_mm_and_si128(lanes, _mm_set1_epi16(mask))}; }
  Words8 shifted_down(int bits) const { return {_mm_srli_epi16(lanes, bits)}; }
};

/// a0 b0 + a1 b1, a2 b2 + a3 b3 ... No sum may exceed 32 bits.
inline Ints4 pair_products(Words8 a, Words8 b) {
  return {_mm_madd_epi16(a.lanes, b.lanes)};
}

/// a0 v + b0 w, a1 v + b1 w ... for the first four words of a and b (low_products) or the last four
/// (high_products). `pairs` is v w v w v w v w.
inline Ints4 low_products(Words8 a, Words8 b, Words8 pairs) {
  return {_mm_madd_epi16(_mm_unpacklo_epi16(a.lanes, b.lanes), pairs.lanes)};
}
inline Ints4 high_products(Words8 a, Words8 b, Words8 pairs) {
  return {_mm_madd_epi16(_mm_unpackhi_epi16(a.lanes, b.lanes), pairs.lanes)};
}

/// Transposes a matrix of four rows.
inline void transpose(Floats4& a, Floats4& b, Floats4& c, Floats4& d) {
  _MM_TRANSPOSE4_PS(a.lanes, b.lanes, c.lanes, d.lanes);
}

}  // namespace mocapress::runtime
