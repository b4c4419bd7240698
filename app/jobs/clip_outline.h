// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QLineF>
#include <QList>
#include <QString>
#include <QStringList>
#include <optional>
#include <string>

#include "core/formats/motion_file.h"
#include "core/motion/loop.h"

namespace mocapress {

/// Summary of a clip for a list.
struct ClipOutline {
  int frames = 0;
  double sample_rate_hz = 0;
  std::string rig;      // rig_of() its skeleton
  QList<QLineF> bones;  // lines of a pose in a square from 0 to 1, y down
  QImage skin;          // picture of the same pose; null: no skin
  QStringList notes;    // repairs and guesses of the reader
  Loop loop = Loop::None;
  Takes takes;
};

/// The take that was read, as ReadOptions names it; unset: the file has no other.
std::optional<std::string> takeAmong(const Takes& takes);

/// Draws the middle frame from its widest side. `skin` may be null.
ClipOutline outlineOf(const Motion& motion, const Skin* skin);

/// Reads a motion or a compressed clip. Throws the readers' exceptions.
ClipOutline readOutline(const QString& path, const QString& skeleton,
                        const ReadOptions& reading = {});

}  // namespace mocapress
