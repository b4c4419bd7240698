// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace mocapress {

/// How long a test waits for what must come; only ever waited for when something is broken.
inline constexpr int kPatience = 120'000;  // ms

/// Lets everything happen that is due now: layouts, queued replots, and what follows from these.
inline void runDueEvents() {
  constexpr int kConsequences = 4;
  for (int i = 0; i < kConsequences; ++i) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }
}

}  // namespace mocapress
