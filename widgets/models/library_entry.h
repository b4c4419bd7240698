// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QList>
#include <QString>
#include <cstddef>
#include <optional>

#include "core/report/review.h"

namespace mocapress {

/// What the last compression of a clip came to.
struct Outcome {
  double ratio = 0;
  double eps_cm = 0;
  double max_cm = 0;
  std::size_t motion_bytes = 0;
  bool met = true;  // the target that was set

  bool operator==(const Outcome&) const = default;
};

/// A clip of the library as it is listed.
struct LibraryEntry {
  QString path;
  int frames = 0;  // 0: not read yet
  double sample_rate_hz = 0;
  QList<QLineF> outline;  // a pose in a square from 0 to 1, y down
  QString trouble;        // why it could not be read; empty: it could, or was not tried
  std::optional<Outcome> outcome;
  Verdict verdict = Verdict::None;
  QString note;
};

}  // namespace mocapress
