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
  std::string rig;      // rig_of() the skeleton
  QList<QLineF> bones;  // lines of a pose in a square from 0 to 1, y down
  QImage skin;          // picture of the same pose; null: no skin
  QStringList notes;    // repairs and guesses of the reader
  Loop loop = Loop::None;
  Takes takes;
};

/// The take that was read, for ReadOptions::take; unset: the file has no other take.
std::optional<std::string> takeAmong(const Takes& takes);

/// Summarises a motion. The picture shows its middle frame, seen from the widest side. `skin` may
/// be null.
ClipOutline outlineOf(const Motion& motion, const Skin* skin);

/// Reads a motion or a compressed clip. Throws the readers' exceptions.
ClipOutline readOutline(const QString& path, const QString& skeleton,
                        const ReadOptions& reading = {});

}  // namespace mocapress
