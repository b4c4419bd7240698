// SPDX-License-Identifier: MIT
// Three numbers (a place, an axis or a moment) at as many frames as a vector has lanes.
#pragma once

#include "core/base/instruction_sets.h"

namespace mocapress {

template <typename Vector>
struct Three {
  Vector x, y, z;
};

template <typename Vector>
MOCAPRESS_INLINE void add(const Three<Vector>& more, Three<Vector>& three) {
  three.x += more.x;
  three.y += more.y;
  three.z += more.z;
}

template <typename Vector>
MOCAPRESS_INLINE void subtract(const Three<Vector>& less, Three<Vector>& three) {
  three.x -= less.x;
  three.y -= less.y;
  three.z -= less.z;
}

template <typename Vector>
MOCAPRESS_INLINE void add_product(const Vector& factor, const Three<Vector>& of,
                                  Three<Vector>& three) {
  three.x += factor * of.x;
  three.y += factor * of.y;
  three.z += factor * of.z;
}

template <typename Vector>
MOCAPRESS_INLINE void dot(const Three<Vector>& a, const Three<Vector>& b, Vector& product) {
  product = a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Vector>
MOCAPRESS_INLINE void cross(const Three<Vector>& a, const Three<Vector>& b,
                            Three<Vector>& product) {
  product.x = a.y * b.z - a.z * b.y;
  product.y = a.z * b.x - a.x * b.z;
  product.z = a.x * b.y - a.y * b.x;
}

}  // namespace mocapress
