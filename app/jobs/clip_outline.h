// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QLineF>
#include <QList>
#include <QString>
#include <QStringList>
#include <string>

#include "core/formats/motion_file.h"

namespace mocapress {

/// What a list shows of a clip.
struct ClipOutline {
  int frames = 0;
  double sample_rate_hz = 0;
  std::string rig;      // rig_of() its skeleton
  QList<QLineF> bones;  // of a pose, in a square from 0 to 1, y down
  QImage skin;          // of the same pose; null: the clip has none
  QStringList notes;    // what the reader repaired or guessed
};

/// The pose in the middle, seen from where it is widest. `skin` may be null.
ClipOutline outlineOf(const Motion& motion, const Skin* skin);

/// Reads a motion or a compressed clip. Throws what the readers throw.
ClipOutline readOutline(const QString& path, const QString& skeleton,
                        const ReadOptions& reading = {});

}  // namespace mocapress
