// SPDX-License-Identifier: MIT
// The kernels that a path of the C interface stands for.
#pragma once

#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/processor/four.h"

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

inline Kernels kernels_of(mcpr_path path) {
#ifdef MOCAPRESS_FOUR
  constexpr Kernels kFour = Kernels::Four;
#else
  constexpr Kernels kFour = Kernels::None;
#endif
  if (path == MCPR_PATH_PLAIN) return Kernels::Plain;
  if (path == MCPR_PATH_AVX2) return has_avx2() ? Kernels::Avx2 : Kernels::None;
  if (path == kPathOfFour) return kFour;
  if (path != MCPR_PATH_BEST) return Kernels::None;
  if (has_avx2()) return Kernels::Avx2;
  return kFour != Kernels::None ? kFour : Kernels::Plain;
}

}  // namespace mocapress::runtime
