// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/jobs/clips.h"

namespace mocapress {

/// What to open, with what is open now: a .mcpr and its original are shown together, in whichever
/// order they are opened.
struct OpenRequest {
  QString path;          // .bvh, .amc or .mcpr
  QString skeleton;      // .asf; empty: the reader looks beside the .amc
  OriginalPtr original;  // open now, or null
  DecodedPtr decoded;    // open now from a .mcpr, or null
  bool compare = false;  // refuse what does not belong to `decoded`
};

/// Either may be null, not both.
struct OpenedClip {
  OriginalPtr original;
  DecodedPtr decoded;
};

bool isCompressedFile(const QString& path);

/// Reads and prepares. Throws what the readers throw, and Error where `compare` finds two clips
/// that do not belong together.
OpenedClip openClip(const OpenRequest& request);

}  // namespace mocapress
