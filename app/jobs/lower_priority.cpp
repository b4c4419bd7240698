// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/lower_priority.h"

#include <QtGlobal>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace mocapress {

void lowerPriority([[maybe_unused]] LowerPriority how) {
#ifdef Q_OS_LINUX
  // On Linux a thread has a niceness of its own, and threads take over that of their maker.
  constexpr int kNice = 10;
  constexpr int kNicest = 19;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()),
              how == LowerPriority::ToTheWindow ? kNice : kNicest);
#endif
}

}  // namespace mocapress
