// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "widgets/models/library_model.h"

namespace mocapress {

/// Kinds of groups of a library's clips. Those after `None` are columns.
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
  QString name;     // Grouping::Folder: the path of the folder; empty: clips have no groups
  double rank = 0;  // groups stand in this order, and by name where it is the same
};

LibraryGroup groupOf(const LibraryEntry& entry, Grouping grouping);

}  // namespace mocapress
