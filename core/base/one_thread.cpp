// SPDX-License-Identifier: MIT
#include "core/base/one_thread.h"

#ifndef __SANITIZE_THREAD__
#include <tbb/task_arena.h>
#endif

namespace mocapress {

void on_one_thread(const std::function<void()>& work) {
#ifdef __SANITIZE_THREAD__
  work();
#else
  tbb::task_arena(1).execute(work);
#endif
}

}  // namespace mocapress
