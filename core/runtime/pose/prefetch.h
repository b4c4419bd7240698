// SPDX-License-Identifier: MIT
// Asks the processor for a cooked clip before it is read. A pose reads some 60 lines of the cache,
// one after the other, as each says where the next is. All of them asked for at once take the time
// of two or three.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/processor/path.h"

namespace mocapress::runtime {

/// Asks for bytes, without waiting. An address beyond what is there does no harm.
inline void prefetch(const std::byte* first, std::size_t bytes) {
#ifdef __GNUC__
  __asm__ volatile("");  // GCC takes calls of a function away that does nothing but prefetch
#endif
  constexpr std::uintptr_t kLine = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(first) / kLine * kLine;
  const auto end = reinterpret_cast<std::uintptr_t>(first) + bytes;
  for (std::uintptr_t at = begin; at < end; at += kLine) {
#ifdef __GNUC__
    __builtin_prefetch(reinterpret_cast<const void*>(at));
#elif defined(MOCAPRESS_HAS_AVX2)
    _mm_prefetch(reinterpret_cast<const char*>(at), _MM_HINT_T0);
#endif
  }
}

/// The head of a clip, the descriptions of rows and entries, and of a clip of one or two seconds
/// nearly all of the rest.
inline constexpr std::size_t kFirstBytes = 4096;

/// Asks for the first bytes of a clip that is about to be read. Does not look at its size, which
/// would have to be waited for.
inline void prefetch_clip(const mcpr_cooked* clip) {
  prefetch(reinterpret_cast<const std::byte*>(clip), kFirstBytes);
}

/// Asks for a clip that is read next, and whose head has been: for all of it unless it is long.
inline void prefetch_next(const mcpr_cooked& clip) {
  constexpr std::size_t kLong = std::size_t{32} << 10;
  prefetch(reinterpret_cast<const std::byte*>(&clip),
           clip.bytes > kLong ? kFirstBytes : static_cast<std::size_t>(clip.bytes));
}

}  // namespace mocapress::runtime
