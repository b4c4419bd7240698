// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "app/jobs/clips.h"
#include "app/jobs/job_runner.h"

namespace mocapress {

struct StudyRow;

/// A file to open, and the clip that is open: a .mcpr and its original are shown together,
/// whichever is opened first.
struct OpenRequest {
  QString path;          // .bvh, .amc or .mcpr
  QString skeleton;      // .asf; empty: the reader looks beside the .amc
  OriginalPtr original;  // open original, or null
  DecodedPtr decoded;    // open .mcpr, or null
  bool compare = false;  // refuse a clip that does not belong to `decoded`

  /// Options to compress with; unset: those of the last clip.
  std::optional<EncodeSettings> options;
  SightLimits limits;                  // for the visibility of clips that are not compressed here
  Characters characters;               // by rig; the clip's rig decides which is put on
  std::optional<ReadOptions> reading;  // for a motion; unset: as it was read last
  std::string comparison;  // for a motion: comparison method to show with `options`, or empty
};

/// A clip that was opened: its original, its compressed form, or both.
struct OpenedClip {
  OriginalPtr original;
  DecodedPtr decoded;
  Characters characters = {};  // those of the request, some of them read meanwhile
};

/// A request that opens the clip of a study's row as compressed there.
OpenRequest requestOf(const StudyRow& row);

bool isCompressedFile(const QString& path);

/// Reads and prepares a clip. Throws the exceptions of readers and of the comparison method, and
/// Error if `compare` is set and the clips do not belong together.
OpenedClip openClip(const OpenRequest& request, const Job& job);

}  // namespace mocapress
