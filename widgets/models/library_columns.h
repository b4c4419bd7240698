// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "widgets/models/library_model.h"

namespace mocapress {

/// The columns of LibraryModel, in their default order.
enum class LibraryColumn {
  Clip,
  Ratio,
  Bytes,
  Error,
  Worst,
  Slide,
  Seen,
  Review,
  Notes,
  Looping,
  Length,
  FromPreset,
  // The change since the earlier batch that clips are compared with.
  Since,
  BytesSince,
  ErrorSince
};

inline constexpr int kLibraryColumns = static_cast<int>(LibraryColumn::ErrorSince) + 1;

QString titleOf(LibraryColumn column);

/// Explains the column, in its header's tool tip.
QString purposeOf(LibraryColumn column);

/// The text of the clip in the column. Empty: not known, or nothing to say.
QString textOf(const LibraryEntry& entry, LibraryColumn column);

bool isNumber(LibraryColumn column);

/// True for columns that are empty unless clips are compared with an earlier batch.
bool isOfComparison(LibraryColumn column);

/// Names a change, such as "newly visible" or "larger".
QString displayName(ClipChange change);

/// The number by which the column is sorted: lengths in cm, times in seconds, changes as shares,
/// kinds by their order. Unset: not known, or the column has texts.
std::optional<double> numberOf(const LibraryEntry& entry, LibraryColumn column);

/// True if `a` comes before `b` when rows are sorted by the column, smallest first. An entry
/// without a value comes before those that have one.
bool isBefore(const LibraryEntry& a, const LibraryEntry& b, LibraryColumn column);

}  // namespace mocapress
