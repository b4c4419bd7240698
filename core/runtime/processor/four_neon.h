// SPDX-License-Identifier: MIT
// The types of four.h with NEON, which every 64-bit ARM processor has.
#pragma once

#include <arm_neon.h>

namespace mocapress::runtime {

struct Floats4 {
  using Real = float;
  static constexpr std::ptrdiff_t kSize = 4;
  float32x4_t lanes;

  static Floats4 all(float value) { return {vdupq_n_f32(value)}; }
  static Floats4 load(const float* from) { return {vld1q_f32(from)}; }
  void store(float* to) const { vst1q_f32(to, lanes); }
};

inline Floats4 operator+(Floats4 a, Floats4 b) {
  return {vaddq_f32(a.lanes, b.lanes)};
}
inline Floats4 operator-(Floats4 a, Floats4 b) {
  return {vsubq_f32(a.lanes, b.lanes)};
}
inline Floats4 operator*(Floats4 a, Floats4 b) {
  return {vmulq_f32(a.lanes, b.lanes)};
}
inline Floats4 operator/(Floats4 a, Floats4 b) {
  return {vdivq_f32(a.lanes, b.lanes)};
}
inline Floats4 square_root(Floats4 a) {
  return {vsqrtq_f32(a.lanes)};
}

struct Ints4 {
  int32x4_t lanes;

  static Ints4 all(std::int32_t value) { return {vdupq_n_s32(value)}; }
  static Ints4 load(const std::int32_t* from) { return {vld1q_s32(from)}; }
  void store(std::int32_t* to) const { vst1q_s32(to, lanes); }
  Floats4 to_floats() const { return {vcvtq_f32_s32(lanes)}; }
  std::int32_t sum() const { return vaddvq_s32(lanes); }
};

inline Ints4 operator+(Ints4 a, Ints4 b) {
  return {vaddq_s32(a.lanes, b.lanes)};
}
inline Ints4 operator-(Ints4 a, Ints4 b) {
  return {vsubq_s32(a.lanes, b.lanes)};
}
inline Ints4 operator&(Ints4 a, Ints4 b) {
  return {vandq_s32(a.lanes, b.lanes)};
}
inline Ints4 operator^(Ints4 a, Ints4 b) {
  return {veorq_s32(a.lanes, b.lanes)};
}
inline Ints4 operator<<(Ints4 a, int bits) {
  return {vshlq_s32(a.lanes, vdupq_n_s32(bits))};
}
inline Ints4 operator>>(Ints4 a, int bits) {
  return {vshlq_s32(a.lanes, vdupq_n_s32(-bits))};
}
inline Ints4 bits_of(Floats4 a) {
  return {vreinterpretq_s32_f32(a.lanes)};
}
inline Floats4 floats_of(Ints4 bits) {
  return {vreinterpretq_f32_s32(bits.lanes)};
}
inline Ints4 has_all(Ints4 a, Ints4 b) {
  return {vreinterpretq_s32_u32(vceqq_s32(vandq_s32(a.lanes, b.lanes), b.lanes))};
}
inline Ints4 either(Ints4 lanes, Ints4 a, Ints4 b) {
  return {vbslq_s32(vreinterpretq_u32_s32(lanes.lanes), b.lanes, a.lanes)};
}

struct Words8 {
  int16x8_t lanes;

  static Words8 load(const void* from) {
    return {vreinterpretq_s16_s8(vld1q_s8(static_cast<const std::int8_t*>(from)))};
  }
  static Words8 of_pairs(Ints4 pairs) { return {vreinterpretq_s16_s32(pairs.lanes)}; }
  static Words8 of_bytes(const void* from) {
    return {vreinterpretq_s16_u16(vmovl_u8(vld1_u8(static_cast<const std::uint8_t*>(from))))};
  }
  static Words8 of_signed_bytes(const void* from) {
    return {vmovl_s8(vld1_s8(static_cast<const std::int8_t*>(from)))};
  }
  static Words8 of_halves(const std::byte* low, const std::byte* high) {
    const int8x8x2_t zipped = vzip_s8(vld1_s8(reinterpret_cast<const std::int8_t*>(low)),
                                      vld1_s8(reinterpret_cast<const std::int8_t*>(high)));
    return {vreinterpretq_s16_s8(vcombine_s8(zipped.val[0], zipped.val[1]))};
  }
  static Words8 packed(Ints4 low, Ints4 high) {
    return {vcombine_s16(vmovn_s32(low.lanes), vmovn_s32(high.lanes))};
  }
  void store(std::int16_t* to) const { vst1q_s16(to, lanes); }

  Ints4 low() const { return {vmovl_s16(vget_low_s16(lanes))}; }
  Ints4 high() const { return {vmovl_high_s16(lanes)}; }
  Ints4 unsigned_low() const {
    return {vreinterpretq_s32_u32(vmovl_u16(vget_low_u16(vreinterpretq_u16_s16(lanes))))};
  }
  Ints4 unsigned_high() const {
    return {vreinterpretq_s32_u32(vmovl_high_u16(vreinterpretq_u16_s16(lanes)))};
  }
  Ints4 pairs() const { return {vreinterpretq_s32_s16(lanes)}; }
  Words8 masked(std::int16_t mask) const { return {vandq_s16(lanes, vdupq_n_s16(mask))}; }
  Words8 shifted_down(int bits) const {
    const int16x8_t by = vdupq_n_s16(static_cast<std::int16_t>(-bits));
    return {vreinterpretq_s16_u16(vshlq_u16(vreinterpretq_u16_s16(lanes), by))};
  }
};

inline Ints4 pair_products(Words8 a, Words8 b) {
  return {vpaddq_s32(vmull_s16(vget_low_s16(a.lanes), vget_low_s16(b.lanes)),
                     vmull_high_s16(a.lanes, b.lanes))};
}
inline Ints4 low_products(Words8 a, Words8 b, Words8 pairs) {
  const int32x4_t first = vmull_laneq_s16(vget_low_s16(a.lanes), pairs.lanes, 0);
  return {vmlal_laneq_s16(first, vget_low_s16(b.lanes), pairs.lanes, 1)};
}
inline Ints4 high_products(Words8 a, Words8 b, Words8 pairs) {
  const int32x4_t first = vmull_high_laneq_s16(a.lanes, pairs.lanes, 0);
  return {vmlal_high_laneq_s16(first, b.lanes, pairs.lanes, 1)};
}

inline void transpose(Floats4& a, Floats4& b, Floats4& c, Floats4& d) {
  const float32x4_t ac_low = vzip1q_f32(a.lanes, c.lanes);
  const float32x4_t ac_high = vzip2q_f32(a.lanes, c.lanes);
  const float32x4_t bd_low = vzip1q_f32(b.lanes, d.lanes);
  const float32x4_t bd_high = vzip2q_f32(b.lanes, d.lanes);
  a = {vzip1q_f32(ac_low, bd_low)};
  b = {vzip2q_f32(ac_low, bd_low)};
  c = {vzip1q_f32(ac_high, bd_high)};
  d = {vzip2q_f32(ac_high, bd_high)};
}

}  // namespace mocapress::runtime
