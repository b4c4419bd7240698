// SPDX-License-Identifier: MIT
// For programs only: a library does not decide how a process handles its memory.
#pragma once

#ifdef __linux__
#include <malloc.h>
#endif

namespace mocapress {

/// Lets glibc keep what is freed instead of giving it back to the system. Encoding takes and frees
/// arrays of some megabytes again and again, and to have them mapped anew each time takes about a
/// tenth of its time.
inline void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  constexpr int kMebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMebibyte);
  mallopt(M_TRIM_THRESHOLD, 256 * kMebibyte);
#endif
}

/// Gives back to the system the freed memory that glibc keeps, which is often in pieces too small
/// to be used again.
inline void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace mocapress
