// SPDX-License-Identifier: MIT
// Compiles number-crunching code twice, with and without AVX2, and runs the version that the
// machine supports. Both versions do the same operations in the same order, without fused
// multiply-adds, so their results are equal bit for bit. The code is one inline function, a
// template over the vector length. with_avx2() runs it with the longer vectors.
#pragma once

#include <cstring>

#if defined(__x86_64__) && defined(__GNUC__)
#define MOCAPRESS_WITH_AVX2
#define MOCAPRESS_FOR_AVX2 __attribute__((target("avx2")))
#define MOCAPRESS_INLINED __attribute__((always_inline))  // for lambdas
#define MOCAPRESS_INLINE MOCAPRESS_INLINED inline
#else
#define MOCAPRESS_INLINED
#define MOCAPRESS_INLINE inline
#endif

namespace mocapress {

using Floats4 = float __attribute__((vector_size(16)));
using Floats8 = float __attribute__((vector_size(32)));
using Doubles1 = double;
using Doubles2 = double __attribute__((vector_size(16)));
using Doubles4 = double __attribute__((vector_size(32)));

template <typename Vector, typename Number>
inline constexpr int kLanes = static_cast<int>(sizeof(Vector) / sizeof(Number));

/// Loads a vector from memory at any alignment.
template <typename Vector, typename Number>
MOCAPRESS_INLINE void load(const Number* from, Vector& vector) {
  std::memcpy(&vector, from, sizeof vector);
}
template <typename Vector, typename Number>
MOCAPRESS_INLINE void store(const Vector& vector, Number* to) {
  std::memcpy(to, &vector, sizeof vector);
}

inline bool has_avx2() {
#ifdef MOCAPRESS_WITH_AVX2
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
#else
  return false;
#endif
}

#ifdef MOCAPRESS_WITH_AVX2
template <typename Work>
MOCAPRESS_FOR_AVX2 bool run_with_avx2(const Work& work) {
  work();
  return true;
}
#endif

/// Runs `work`, a lambda marked MOCAPRESS_INLINED, with AVX2. Returns false on machines without
/// AVX2.
template <typename Work>
bool with_avx2([[maybe_unused]] const Work& work) {
#ifdef MOCAPRESS_WITH_AVX2
  return has_avx2() && run_with_avx2(work);
#else
  return false;
#endif
}

}  // namespace mocapress
