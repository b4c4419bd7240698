// SPDX-License-Identifier: MIT
// Rotations of joints: from channels to a matrix and back. The encoder uses these templates with
// Eigen's types, the runtime with those of space.h. A matrix is any type with (row, column), a
// vector any type with [i].
#pragma once

#include <cmath>
#include <cstdint>

#include "core/runtime/format/trigonometry.h"

namespace mocapress::runtime {

constexpr bool is_rotation(std::uint8_t kind) {
  return kind >= 3;
}
constexpr int axis_of(std::uint8_t kind) {
  return kind % 3;
}

/// Replaces m by m * rotation by `radians` about coordinate axis 0, 1 or 2. This mixes two columns.
template <typename Matrix>
void turn_about(int axis, double radians, Matrix& m) {
  const int next = axis == 2 ? 0 : axis + 1;
  const int last = axis == 0 ? 2 : axis - 1;
  const auto [s, c] = sine_and_cosine(radians);
  for (int row = 0; row < 3; ++row) {
    const double a = m(row, next);
    const double b = m(row, last);
    m(row, next) = c * a + s * b;
    m(row, last) = c * b - s * a;
  }
}

/// Applies a joint's channels in order. Multiplies `rotation` by each rotation on the right, and
/// adds translations (cm) to `translation`. Kinds 0 1 2 are translations along x y z, 3 4 5
/// rotations about them; `value(c)` is the value of channel c.
template <typename Kind, typename Value, typename Matrix, typename Vector>
void apply_channels(const Kind* kinds, int count, const Value& value, Matrix& rotation,
                    Vector& translation) {
  for (int c = 0; c < count; ++c) {
    const auto kind = static_cast<std::uint8_t>(kinds[c]);
    if (is_rotation(kind))
      turn_about(axis_of(kind), value(c), rotation);
    else
      translation[axis_of(kind)] += value(c);
  }
}

/// `angle` plus the whole number of turns that brings it nearest to `previous`, in radians.
inline double nearest_turn(double angle, double previous) {
  constexpr double kTurn = 2 * kPi;
  return angle - kTurn * std::round((angle - previous) / kTurn);
}

/// Decomposes a rotation into angles R_i(a) R_j(b) R_k(c) about three different axes (0 1 2: x y
/// z). Returns the solution nearer to `previous`.
template <typename Axes, typename Matrix, typename Vector>
Vector three_angles(const Axes& axes, const Matrix& rotation, const Vector& previous) {
  constexpr double kGimbalLock = 1e-9;
  const int i = axes[0];
  const int j = axes[1];
  const int k = axes[2];
  const double sign = (i + 1) % 3 == j ? 1 : -1;  // 1 for an even permutation of x y z, -1 for an
                                                  // odd one
  const double a =
      std::sqrt(rotation(i, i) * rotation(i, i) + rotation(i, j) * rotation(i, j)) > kGimbalLock
          ? arc_tangent(-sign * rotation(j, k), rotation(k, k))
          : previous[0];
  // R_i(-a) * rotation = R_j(b) R_k(c). Multiplying by R_i(-a) mixes rows j and k.
  const SineAndCosine of_a = sine_and_cosine(a);
  const double cosine = of_a.cosine;
  const double sine = sign * of_a.sine;
  const auto row_j = [&](int column) {
    return cosine * rotation(j, column) + sine * rotation(k, column);
  };
  const double b =
      arc_tangent(sign * rotation(i, k), cosine * rotation(k, k) - sine * rotation(j, k));
  const double c = arc_tangent(sign * row_j(i), row_j(j));
  const double solutions[2][3] = {{a, b, c}, {a + kPi, kPi - b, c + kPi}};
  Vector found[2];
  double distance[2] = {};
  for (int s = 0; s < 2; ++s)
    for (int angle = 0; angle < 3; ++angle) {
      found[s][angle] = nearest_turn(solutions[s][angle], previous[angle]);
      const double difference = found[s][angle] - previous[angle];
      distance[s] += difference * difference;
    }
  return distance[0] <= distance[1] ? found[0] : found[1];
}

}  // namespace mocapress::runtime
