// SPDX-License-Identifier: MIT
// For programs only: a library must not decide how a process handles its memory.
#pragma once

#ifdef __linux__
#include <malloc.h>
#endif

namespace mocapress {

/// Lets glibc keep freed memory instead of giving it back to the system. Encoding allocates and
/// frees arrays of some megabytes again and again; mapping them anew each time takes about a tenth
/// of the encoding time.
inline void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  constexpr int kMebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMebibyte);
  mallopt(M_TRIM_THRESHOLD, 256 * kMebibyte);
#endif
}

/// Gives the freed memory that glibc keeps back to the system. It is often in pieces too small to
/// be used again.
inline void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace mocapress
