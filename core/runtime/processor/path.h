// SPDX-License-Identifier: MIT
// Maps a path of the C interface to the kernels that compute it.
#pragma once

#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/processor/four.h"

#if defined(MOCAPRESS_HAS_AVX2) && defined(_MSC_VER)
#include <intrin.h>
#endif

namespace mocapress::runtime {

enum class Kernels {
  None,  // this build or this machine does not have the path
  Plain,
  Four,
  Avx2
};

#if defined(__aarch64__)
inline constexpr mcpr_path kPathOfFour = MCPR_PATH_NEON;
#elif defined(__wasm__)
inline constexpr mcpr_path kPathOfFour = MCPR_PATH_WASM;
#else
inline constexpr mcpr_path kPathOfFour = MCPR_PATH_SSE2;
#endif

/// True if both the machine and its operating system support AVX2.
inline bool has_avx2() {
#if !defined(MOCAPRESS_HAS_AVX2)
  return false;
#elif defined(_MSC_VER)
  int leaf[4];
  __cpuid(leaf, 0);
  if (leaf[0] < 7) return false;
  __cpuid(leaf, 1);
  constexpr int kSavesRegisters = 1 << 27;  // OSXSAVE: the system saves the registers that XCR0
                                            // names
  if ((leaf[2] & kSavesRegisters) == 0 || (_xgetbv(0) & 6) != 6) return false;
  __cpuidex(leaf, 7, 0);
  return (leaf[1] & 1 << 5) != 0;
#else
  return __builtin_cpu_supports("avx2") != 0;
#endif
}

inline Kernels kernels_of(mcpr_path path) {
#ifdef MOCAPRESS_FOUR
  constexpr Kernels kFour = Kernels::Four;
#else
  constexpr Kernels kFour = Kernels::None;
#endif
#ifdef MOCAPRESS_FOUR_ALONE  // a build that leaves the plain kernels out, to be smaller
  static_assert(kFour != Kernels::None);
#else
  if (path == MCPR_PATH_PLAIN) return Kernels::Plain;
#endif
  if (path == MCPR_PATH_AVX2) return has_avx2() ? Kernels::Avx2 : Kernels::None;
  if (path == kPathOfFour) return kFour;
  if (path != MCPR_PATH_BEST) return Kernels::None;
  if (has_avx2()) return Kernels::Avx2;
  return kFour != Kernels::None ? kFour : Kernels::Plain;
}

}  // namespace mocapress::runtime
