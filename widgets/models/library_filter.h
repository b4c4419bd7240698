// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>
#include <vector>

#include "widgets/models/library_columns.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// Choices of the clips that a library shows.
enum class LibraryShow {
  All,
  NotReviewed,
  ToReview,  // not reviewed, or the verdict is stale
  Approved,
  Rejected,
  Stale,  // the verdict or the outcome is stale
  WithNotes,
  WithWarnings,
  Visible,     // visible or borderline errors
  Unfinished,  // not compressed yet with their present settings
  Missed       // target missed, or the clip cannot be read or compressed
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

/// The clips of a library that match the filter, sorted by a column, or in the library's order for
/// column -1.
class LibraryFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit LibraryFilter(LibraryModel* clips, QObject* parent = nullptr);

  /// Sets the words that must each occur in a clip's path, take, state, loop or preset; empty: any
  /// clip. A word such as "error>0.5" or "bytes since >= 5 %" bounds the number in the column whose
  /// title begins with that text. Numbers without a unit are lengths in cm, times in seconds, or
  /// changes of the bytes in %.
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
