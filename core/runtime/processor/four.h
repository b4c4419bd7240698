// SPDX-License-Identifier: MIT
// Vectors of four numbers for the instruction set that this build is compiled for. MOCAPRESS_FOUR
// is defined if it has such vectors. Each of the files included below defines the same types and
// functions:
//   Floats4  four floats: load() store() all(), + - * / square_root() by element
//   Ints4    four integers of 32 bits with wrap-around: load() store() all(), + - & ^ << and >>,
//            which keeps signs
//   Words8   eight integers of 16 bits
// 32-bit ARM does not use its vectors: they flush denormal floats to zero, which gives other bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/processor/processor.h"

#if defined(__SSE2__) || defined(_M_X64)
#define MOCAPRESS_FOUR
#include "core/runtime/processor/four_sse2.h"
#elif defined(__aarch64__) && defined(__ARM_NEON)
#define MOCAPRESS_FOUR
#include "core/runtime/processor/four_neon.h"
#elif defined(__wasm_simd128__)
#define MOCAPRESS_FOUR
#include "core/runtime/processor/four_wasm.h"
#endif
