// SPDX-License-Identifier: MIT
// The types of four.h with the 128-bit vectors of WebAssembly: -msimd128.
#pragma once

#include <wasm_simd128.h>

namespace mocapress::runtime {

struct Floats4 {
  using Real = float;
  static constexpr std::ptrdiff_t kSize = 4;
  v128_t lanes;

  static Floats4 all(float value) { return {wasm_f32x4_splat(value)}; }
  static Floats4 load(const float* from) { return {wasm_v128_load(from)}; }
  void store(float* to) const { wasm_v128_store(to, lanes); }
};

inline Floats4 operator+(Floats4 a, Floats4 b) {
  return {wasm_f32x4_add(a.lanes, b.lanes)};
}
inline Floats4 operator-(Floats4 a, Floats4 b) {
  return {wasm_f32x4_sub(a.lanes, b.lanes)};
}
inline Floats4 operator*(Floats4 a, Floats4 b) {
  return {wasm_f32x4_mul(a.lanes, b.lanes)};
}
inline Floats4 operator/(Floats4 a, Floats4 b) {
  return {wasm_f32x4_div(a.lanes, b.lanes)};
}
inline Floats4 square_root(Floats4 a) {
  return {wasm_f32x4_sqrt(a.lanes)};
}

struct Ints4 {
  v128_t lanes;

  static Ints4 all(std::int32_t value) { return {wasm_i32x4_splat(value)}; }
  static Ints4 load(const std::int32_t* from) { return {wasm_v128_load(from)}; }
  void store(std::int32_t* to) const { wasm_v128_store(to, lanes); }
  Floats4 to_floats() const { return {wasm_f32x4_convert_i32x4(lanes)}; }
  std::int32_t sum() const {
    const v128_t two = wasm_i32x4_add(lanes, wasm_i32x4_shuffle(lanes, lanes, 2, 3, 0, 1));
    return wasm_i32x4_extract_lane(wasm_i32x4_add(two, wasm_i32x4_shuffle(two, two, 1, 0, 3, 2)),
                                   0);
  }
};

inline Ints4 operator+(Ints4 a, Ints4 b) {
  return {wasm_i32x4_add(a.lanes, b.lanes)};
}
inline Ints4 operator-(Ints4 a, Ints4 b) {
  return {wasm_i32x4_sub(a.lanes, b.lanes)};
}
inline Ints4 operator&(Ints4 a, Ints4 b) {
  return {wasm_v128_and(a.lanes, b.lanes)};
}
inline Ints4 operator^(Ints4 a, Ints4 b) {
  return {wasm_v128_xor(a.lanes, b.lanes)};
}
inline Ints4 operator<<(Ints4 a, int bits) {
  return {wasm_i32x4_shl(a.lanes, static_cast<std::uint32_t>(bits))};
}
inline Ints4 operator>>(Ints4 a, int bits) {
  return {wasm_i32x4_shr(a.lanes, static_cast<std::uint32_t>(bits))};
}
inline Ints4 bits_of(Floats4 a) {
  return {a.lanes};
}
inline Floats4 floats_of(Ints4 bits) {
  return {bits.lanes};
}
inline Ints4 has_all(Ints4 a, Ints4 b) {
  return {wasm_i32x4_eq(wasm_v128_and(a.lanes, b.lanes), b.lanes)};
}
inline Ints4 either(Ints4 lanes, Ints4 a, Ints4 b) {
  return {wasm_v128_bitselect(b.lanes, a.lanes, lanes.lanes)};
}

struct Words8 {
  v128_t lanes;

  static Words8 load(const void* from) { return {wasm_v128_load(from)}; }
  static Words8 of_pairs(Ints4 pairs) { return {pairs.lanes}; }
  static Words8 of_bytes(const void* from) { return {wasm_u16x8_load8x8(from)}; }
  static Words8 of_signed_bytes(const void* from) { return {wasm_i16x8_load8x8(from)}; }
  static Words8 of_halves(const std::byte* low, const std::byte* high) {
    return {wasm_i8x16_shuffle(wasm_v128_load64_zero(low), wasm_v128_load64_zero(high), 0, 16, 1,
                               17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23)};
  }
  static Words8 packed(Ints4 low, Ints4 high) {
    return {wasm_i16x8_narrow_i32x4(low.lanes, high.lanes)};
  }
  void store(std::int16_t* to) const { wasm_v128_store(to, lanes); }

  Ints4 low() const { return {wasm_i32x4_extend_low_i16x8(lanes)}; }
  Ints4 high() const { return {wasm_i32x4_extend_high_i16x8(lanes)}; }
  Ints4 unsigned_low() const { return {wasm_u32x4_extend_low_u16x8(lanes)}; }
  Ints4 unsigned_high() const { return {wasm_u32x4_extend_high_u16x8(lanes)}; }
  Ints4 pairs() const { return {lanes}; }
  Words8 masked(std::int16_t mask) const { return {wasm_v128_and(lanes, wasm_i16x8_splat(mask))}; }
  Words8 shifted_down(int bits) const {
    return {wasm_u16x8_shr(lanes, static_cast<std::uint32_t>(bits))};
  }
};

inline Ints4 pair_products(Words8 a, Words8 b) {
  return {wasm_i32x4_dot_i16x8(a.lanes, b.lanes)};
}
inline Ints4 low_products(Words8 a, Words8 b, Words8 pairs) {
  const v128_t zipped = wasm_i16x8_shuffle(a.lanes, b.lanes, 0, 8, 1, 9, 2, 10, 3, 11);
  return {wasm_i32x4_dot_i16x8(zipped, pairs.lanes)};
}
inline Ints4 high_products(Words8 a, Words8 b, Words8 pairs) {
  const v128_t zipped = wasm_i16x8_shuffle(a.lanes, b.lanes, 4, 12, 5, 13, 6, 14, 7, 15);
  return {wasm_i32x4_dot_i16x8(zipped, pairs.lanes)};
}

inline void transpose(Floats4& a, Floats4& b, Floats4& c, Floats4& d) {
  const v128_t ab_low = wasm_i32x4_shuffle(a.lanes, b.lanes, 0, 4, 1, 5);
  const v128_t ab_high = wasm_i32x4_shuffle(a.lanes, b.lanes, 2, 6, 3, 7);
  const v128_t cd_low = wasm_i32x4_shuffle(c.lanes, d.lanes, 0, 4, 1, 5);
  const v128_t cd_high = wasm_i32x4_shuffle(c.lanes, d.lanes, 2, 6, 3, 7);
  a = {wasm_i32x4_shuffle(ab_low, cd_low, 0, 1, 4, 5)};
  b = {wasm_i32x4_shuffle(ab_low, cd_low, 2, 3, 6, 7)};
  c = {wasm_i32x4_shuffle(ab_high, cd_high, 0, 1, 4, 5)};
  d = {wasm_i32x4_shuffle(ab_high, cd_high, 2, 3, 6, 7)};
}

}  // namespace mocapress::runtime
