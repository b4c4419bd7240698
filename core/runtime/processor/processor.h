// SPDX-License-Identifier: MIT
// The instruction sets that this build has: AVX2 is chosen at run time, vectors of four (four.h)
// at compile time. Refuses compilers and machines that cannot give the promised bits.
#pragma once

#include <cfloat>

#if !defined(_MSC_VER) && __cplusplus < 202002L
#error "the Mocapress runtime needs C++20: -std=c++20"
#elif defined(_MSC_VER) && _MSVC_LANG < 202002L
#error "the Mocapress runtime needs C++20: /std:c++20"
#endif
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error \
    "the Mocapress runtime needs a little-endian machine: files and cooked clips are used in place"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error \
    "the Mocapress runtime needs floats of 32 bits between operations: -msse2 -mfpmath=sse on x86"
#endif

// A function with MOCAPRESS_AVX2 may use AVX2, and may be called only if has_avx2(). GCC and clang
// need an attribute for that; MSVC compiles the intrinsics anywhere.
#if (defined(__x86_64__) && defined(__GNUC__)) || (defined(_M_X64) && defined(__clang__))
#define MOCAPRESS_HAS_AVX2
#define MOCAPRESS_AVX2 __attribute__((target("avx2")))
#elif defined(_M_X64) && defined(_MSC_VER)
#define MOCAPRESS_HAS_AVX2
#define MOCAPRESS_AVX2
#endif

#if defined(__GNUC__) || defined(__clang__)
#define MOCAPRESS_ALWAYS_INLINE __attribute__((always_inline)) inline
#elif defined(_MSC_VER)
#define MOCAPRESS_ALWAYS_INLINE __forceinline
#else
#define MOCAPRESS_ALWAYS_INLINE inline
#endif

/// Unrolls the loop that follows.
#ifdef __GNUC__
#define MOCAPRESS_PRAGMA(words) _Pragma(#words)
#define MOCAPRESS_UNROLL(times) MOCAPRESS_PRAGMA(GCC unroll times)
#else
#define MOCAPRESS_UNROLL(times)
#endif
