// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>
#include <vector>

#include "widgets/models/library_columns.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// Kinds of clips that a library can show alone.
enum class LibraryShow {
  All,
  NotReviewed,
  ToReview,  // not reviewed, or stale
  Approved,
  Rejected,
  Stale,  // the verdict, or the outcome
  WithNotes,
  WithWarnings,
  Visible,     // visible or borderline errors
  Unfinished,  // not compressed yet by their settings
  Missed       // no target met, or not to be read or compressed
};

QString displayName(LibraryShow show);

/// A bound on the number in a column.
struct ColumnBound {
  LibraryColumn column = LibraryColumn::Error;
  bool is_above = true;           // larger numbers match; false: smaller ones
  bool is_met_by_equals = false;  // the bound itself matches, too
  double value = 0;

  bool matches(const LibraryEntry& entry) const;
};

/// The clips of a library that match, sorted by a column; with column -1, in the library's order.
class LibraryFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit LibraryFilter(LibraryModel* clips, QObject* parent = nullptr);

  /// Words that name, folder, state, loop or preset must all have; empty: no matter. A word such as
  /// "error>0.5" or "bytes since >= 5 %" bounds the number in the column whose title begins so.
  /// Without a unit lengths are in cm, times in seconds, and changes of the bytes in %.
  void setWords(const QString& words);
  void setShow(LibraryShow show);

  const LibraryModel* clips() const { return clips_; }
  const LibraryEntry& entry(int row) const { return clips_->entry(clipAt(row)); }
  int clipAt(int row) const { return mapToSource(index(row, 0)).row(); }
  int rowOf(int clip) const { return mapFromSource(clips_->index(clip, 0)).row(); }

 protected:
  bool filterAcceptsRow(int clip, const QModelIndex&) const override;
  bool lessThan(const QModelIndex& a, const QModelIndex& b) const override;

 private:
  LibraryModel* clips_;
  QStringList words_;
  std::vector<ColumnBound> bounds_;
  LibraryShow show_ = LibraryShow::All;
};

}  // namespace mocapress
