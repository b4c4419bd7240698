// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "app/jobs/clips.h"
#include "app/jobs/job_runner.h"

namespace mocapress {

struct StudyRow;

/// What to open, with what is open now: a .mcpr and its original are shown together, in whichever
/// order they are opened.
struct OpenRequest {
  QString path;          // .bvh, .amc or .mcpr
  QString skeleton;      // .asf; empty: the reader looks beside the .amc
  OriginalPtr original;  // open now, or null
  DecodedPtr decoded;    // open now from a .mcpr, or null
  bool compare = false;  // refuse what does not belong to `decoded`

  /// By what to compress it; unset: as the last clip was.
  std::optional<EncodeSettings> options;
  Characters characters;               // one of them is put on it, and read where it was not
  std::optional<ReadOptions> reading;  // of a motion; unset: as the clip was read last
  std::string comparison;  // of a motion: the comparison method to show, by `options`; else empty
};

/// Either may be null, not both.
struct OpenedClip {
  OriginalPtr original;
  DecodedPtr decoded;
  Characters characters = {};  // of the request, with what was read of them
};

/// What opens the clip of a row of a study as it is compressed there.
OpenRequest requestOf(const StudyRow& row);

bool isCompressedFile(const QString& path);

/// Reads and prepares. Throws what the readers throw, Error where `compare` finds two clips that do
/// not belong together, and what the comparison method throws.
OpenedClip openClip(const OpenRequest& request, const Job& job);

}  // namespace mocapress
