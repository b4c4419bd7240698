// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "widgets/models/library_model.h"

namespace mocapress {

/// Criteria by which a library's clips are grouped. Those after `None` are columns.
enum class Grouping {
  Folder,
  Verdict,
  Seen,
  None,
  Ratio,
  Bytes,
  Error,
  Slide,
  Warned,
  Looping,
  Preset,
  Worst,
  Length
};

inline constexpr int kGroupings = static_cast<int>(Grouping::Length) + 1;

QString displayName(Grouping grouping);

/// A group of clips. Numbers are grouped by their size, as in "20 to 50".
struct LibraryGroup {
  QString name;     // for Grouping::Folder the folder's path; empty: clips have no groups
  double rank = 0;  // groups are sorted by rank, then by name
};

LibraryGroup groupOf(const LibraryEntry& entry, Grouping grouping);

}  // namespace mocapress
