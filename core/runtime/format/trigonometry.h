// SPDX-License-Identifier: MIT
// Sine, cosine and their inverses in double precision. The functions of C libraries differ between
// machines in the last bit. These give the same bits everywhere, because they only add, multiply,
// divide and take roots. Their error is less than one unit in the last place (inverses: two).
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace mocapress::runtime {

inline constexpr double kPi = 0x1.921fb54442d18p+1;

struct SineAndCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in radians. Beyond a million radians, which no motion reaches, whole
/// turns are subtracted first, with the error of a rounded pi.
inline SineAndCosine sine_and_cosine(double angle) {
  if (std::abs(angle) > 0x1p20) angle = std::fmod(angle, 2 * kPi);
  // Subtracts quarter turns. pi / 2 is split into three parts, so that the products with the first
  // two are exact. `rest` is the rounding error of `near`. Adding kRound leaves a whole number in
  // the lowest bits.
  constexpr double kRound = 0x1.8p52;
  const double counted = angle * (2 / kPi) + kRound;
  const double quarters = counted - kRound;
  const double first = angle - quarters * 0x1.921fb544p+0;
  const double second = quarters * 0x1.0b4611a6p-34;
  const double near = first - second;
  const double rest = ((first - near) - second) - quarters * 0x1.3198a2e037073p-69;
  // Taylor series at near + rest, which is at most an eighth of a turn.
  const double z = near * near;
  const double odd =
      z * (-1.0 / 6 +
           z * (1.0 / 120 +
                z * (-1.0 / 5040 +
                     z * (1.0 / 362880 +
                          z * (-1.0 / 39916800 +
                               z * (1.0 / 6227020800 +
                                    z * (-1.0 / 1307674368000 + z * (1.0 / 355687428096000))))))));
  const double even =
      z * z *
      (1.0 / 24 +
       z * (-1.0 / 720 +
            z * (1.0 / 40320 +
                 z * (-1.0 / 3628800 + z * (1.0 / 479001600 + z * (-1.0 / 87178291200 +
                                                                   z * (1.0 / 20922789888000)))))));
  const double half = 0.5 * z;
  const double sine = near + (near * odd + rest * (1 - half));
  const double most = 1 - half;
  const double cosine = most + (((1 - most) - half) + (even - near * rest));
  std::uint64_t quadrant;
  std::memcpy(&quadrant, &counted, sizeof quadrant);
  switch (quadrant & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

/// The angle of the direction x, y, as std::atan2.
inline double arc_tangent(double y, double x) {
  constexpr double kOfEighths[] = {// arc tangents of 0, 1/8 ... 1
                                   0x0p+0,
                                   0x1.fd5ba9aac2f6ep-4,
                                   0x1.f5b75f92c80ddp-3,
                                   0x1.6f61941e4def1p-2,
                                   0x1.dac670561bb4fp-2,
                                   0x1.1e00babdefeb4p-1,
                                   0x1.4978fa3269ee1p-1,
                                   0x1.700a7c5784634p-1,
                                   0x1.921fb54442d18p-1};
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const double across = std::abs(y);
  const double along = std::abs(x);
  const bool is_steep = across > along;
  const double less = is_steep ? along : across;
  const double more = is_steep ? across : along;
  double angle = 0;
  if (more > 0 && std::isfinite(more)) {
    const int eighths = static_cast<int>(8 * (less / more) + 0.5);
    const double slope = eighths / 8.0;
    const double t = (less - slope * more) / (more + slope * less);  // at most 1/16
    const double z = t * t;
    const double series =
        z * (-1.0 / 3 +
             z * (1.0 / 5 +
                  z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13 - z / 15))))));
    angle = kOfEighths[eighths] + (t + t * series);
  } else if (more > 0) {
    angle = less == more ? kPi / 4 : 0;
  }
  if (is_steep) angle = kPi / 2 - angle;
  if (std::signbit(x)) angle = kPi - angle;
  return std::copysign(angle, y);
}

/// -1 <= cosine <= 1
inline double arc_cosine(double cosine) {
  return arc_tangent(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

}  // namespace mocapress::runtime
