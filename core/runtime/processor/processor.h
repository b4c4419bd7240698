// SPDX-License-Identifier: MIT
// The instruction sets that this build has. AVX2 is chosen at run time; vectors of four (four.h)
// are chosen at compile time. This file refuses compilers and machines that cannot give the
// promised bits.
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

// Marks a function that uses AVX2. Call it only if has_avx2(). GCC and clang need an attribute to
// compile such a function; MSVC does not.
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

/// MOCAPRESS_UNROLL unrolls the loop that follows it.
#ifdef __GNUC__
#define MOCAPRESS_PRAGMA(words) _Pragma(#words)
#define MOCAPRESS_UNROLL(times) MOCAPRESS_PRAGMA(GCC unroll times)
#else
#define MOCAPRESS_UNROLL(times)
#endif
