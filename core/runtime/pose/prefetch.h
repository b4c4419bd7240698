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

/// Asks for the first bytes of a clip, without waiting: its head, the descriptions of rows and
/// entries, and of a clip of one or two seconds nearly all of the rest. Does not look at the size,
/// which would have to be waited for: an address beyond the clip does no harm.
inline void prefetch_clip(const mcpr_cooked* clip) {
  constexpr std::uintptr_t kBytes = 4096;
  constexpr std::uintptr_t kLine = 64;
  const auto first = reinterpret_cast<std::uintptr_t>(clip);
  for (std::uintptr_t at = first; at < first + kBytes; at += kLine) {
#ifdef __GNUC__
    __builtin_prefetch(reinterpret_cast<const void*>(at));
#elif defined(MOCAPRESS_HAS_AVX2)
    _mm_prefetch(reinterpret_cast<const char*>(at), _MM_HINT_T0);
#endif
  }
}

}  // namespace mocapress::runtime
