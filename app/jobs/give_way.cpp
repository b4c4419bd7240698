// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/give_way.h"

#include <QtGlobal>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace mocapress {

void giveWay([[maybe_unused]] GiveWay how) {
#ifdef Q_OS_LINUX
  // On Linux a thread has a niceness of its own, and threads take over that of their maker.
  constexpr int kNice = 10;
  constexpr int kNicest = 19;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()),
              how == GiveWay::ToTheWindow ? kNice : kNicest);
#endif
}

}  // namespace mocapress
