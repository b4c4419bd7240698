// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace mocapress {

/// The longest wait for an event; it is only reached when something is broken.
inline constexpr int kPatience = 120'000;  // ms

/// Handles everything that is due: layouts, queued replots, and events that follow from them.
inline void runDueEvents() {
  constexpr int kConsequences = 4;
  for (int i = 0; i < kConsequences; ++i) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }
}

}  // namespace mocapress
