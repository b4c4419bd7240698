// SPDX-License-Identifier: MIT
// Transforms in single precision, for blending poses: of one joint (Real = float), or of four
// joints at once (Real = Floats4). Both compute the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/runtime/format/bit_pattern.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/processor/four.h"

namespace mocapress::runtime {

/// Number of joints in a Real: 1 for float, 4 for Floats4.
template <typename Real>
inline constexpr std::uint32_t kJointsOf = sizeof(Real) / sizeof(float);

template <typename Real>
Real all_joints(float value) {
  if constexpr (kJointsOf<Real> == 1)
    return value;
  else
    return Real::all(value);
}

/// Loads one number per joint, from consecutive floats.
template <typename Real>
Real each_joint(const float* from) {
  if constexpr (kJointsOf<Real> == 1)
    return *from;
  else
    return Real::load(from);
}

inline float square_root(float a) {
  return std::sqrt(a);
}

/// `a` if `by` is positive, -a if `by` has a minus sign.
inline float negated_by(float by, float a) {
  constexpr std::uint32_t kSign = 0x80000000U;
  return bit_pattern<float>(bit_pattern<std::uint32_t>(a) ^
                            (bit_pattern<std::uint32_t>(by) & kSign));
}
#ifdef MOCAPRESS_FOUR
inline Floats4 negated_by(Floats4 by, Floats4 a) {
  constexpr std::int32_t kSign = INT32_MIN;
  return floats_of(bits_of(a) ^ (bits_of(by) & Ints4::all(kSign)));
}
#endif

/// A rotation.
template <typename Real>
struct Turn {
  Real w, x, y, z;
};

template <typename Real>
MOCAPRESS_ALWAYS_INLINE Turn<Real> operator*(const Turn<Real>& a, const Turn<Real>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

template <typename Real>
Turn<Real> operator*(Real factor, const Turn<Real>& a) {
  return {factor * a.w, factor * a.x, factor * a.y, factor * a.z};
}

template <typename Real>
Turn<Real> operator+(const Turn<Real>& a, const Turn<Real>& b) {
  return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}

template <typename Real>
Real dot(const Turn<Real>& a, const Turn<Real>& b) {
  return (a.w * b.w + a.x * b.x) + (a.y * b.y + a.z * b.z);
}

template <typename Real>
MOCAPRESS_ALWAYS_INLINE Turn<Real> inverse(const Turn<Real>& a) {
  const Real none = all_joints<Real>(0);
  return {a.w, none - a.x, none - a.y, none - a.z};
}

template <typename Real>
MOCAPRESS_ALWAYS_INLINE Turn<Real> normalised(const Turn<Real>& a) {
  return all_joints<Real>(1) / square_root(dot(a, a)) * a;
}

/// Interpolates from no turn (share 0) to `a` (share 1), the shorter way round, by a normalised sum
/// of quaternions.
template <typename Real>
MOCAPRESS_ALWAYS_INLINE Turn<Real> part_of(const Turn<Real>& a, Real share) {
  const Real towards = negated_by(a.w, share);
  return normalised(Turn<Real>{(all_joints<Real>(1) - share) + towards * a.w, towards * a.x,
                               towards * a.y, towards * a.z});
}

template <typename Real>
struct Shift {
  Real x, y, z;
};

template <typename Real>
Shift<Real> operator+(const Shift<Real>& a, const Shift<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Real>
Shift<Real> operator-(const Shift<Real>& a, const Shift<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Real>
Shift<Real> operator*(Real factor, const Shift<Real>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}

/// Rotates a vector: v + 2 (w (u x v) + u x (u x v)), where u is the vector part of q.
template <typename Real>
MOCAPRESS_ALWAYS_INLINE Shift<Real> turned(const Turn<Real>& q, const Shift<Real>& v) {
  const Shift<Real> a{q.y * v.z - q.z * v.y, q.z * v.x - q.x * v.z, q.x * v.y - q.y * v.x};
  const Shift<Real> b{q.y * a.z - q.z * a.y, q.z * a.x - q.x * a.z, q.x * a.y - q.y * a.x};
  return v + all_joints<Real>(2) * (q.w * a + b);
}

/// The transforms of kJointsOf<Real> joints. Quaternions are w x y z. Code that works for any order
/// may use the order of the poses.
template <typename Real>
struct Placed {
  Turn<Real> turn;
  Shift<Real> shift;

  MOCAPRESS_ALWAYS_INLINE static Placed load(const mcpr_transform* from) {
    if constexpr (kJointsOf<Real> == 1) {
      const float* const q = from->rotation;
      const float* const t = from->translation;
      return {{q[0], q[1], q[2], q[3]}, {t[0], t[1], t[2]}};
    } else {
      Real q[4], t[4];
      for (int i = 0; i < 4; ++i) {
        q[i] = Real::load(from[i].rotation);
        t[i] = Real::load(from[i].translation);
      }
      transpose(q[0], q[1], q[2], q[3]);
      transpose(t[0], t[1], t[2], t[3]);
      return {{q[0], q[1], q[2], q[3]}, {t[0], t[1], t[2]}};
    }
  }

  MOCAPRESS_ALWAYS_INLINE void store(mcpr_transform* to) const {
    if constexpr (kJointsOf<Real> == 1) {
      *to = {{turn.w, turn.x, turn.y, turn.z}, {shift.x, shift.y, shift.z, 0}};
    } else {
      Real q[4] = {turn.w, turn.x, turn.y, turn.z};
      Real t[4] = {shift.x, shift.y, shift.z, Real::all(0)};
      transpose(q[0], q[1], q[2], q[3]);
      transpose(t[0], t[1], t[2], t[3]);
      for (int i = 0; i < 4; ++i) {
        q[i].store(to[i].rotation);
        t[i].store(to[i].translation);
      }
    }
  }
};

/// Calls work(a value of type Real, joint number) for four joints at a time, then for each
/// remaining joint.
template <typename Work>
void for_joints(std::uint32_t joints, const Work& work) {
  std::uint32_t j = 0;
#ifdef MOCAPRESS_FOUR
  for (; joints - j >= 4; j += 4) work(Floats4{}, j);
#endif
  for (; j < joints; ++j) work(float{}, j);
}

}  // namespace mocapress::runtime
