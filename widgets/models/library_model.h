// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <vector>

#include "widgets/models/library_entry.h"

namespace mocapress {

/// The clips of a project, one row each. The text of a row says all that its picture does.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<LibraryEntry> entries);

  /// Of the entry with that path, or a new row at the end.
  void setEntry(const LibraryEntry& entry);
  /// New rows at the end, of paths that have none yet.
  void addEntries(const std::vector<LibraryEntry>& entries);

  const LibraryEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  int rowOf(const QString& path) const;  // -1: none

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// "25.0 : 1, 0.09 cm", or why there is nothing to say yet.
QString outcomeText(const LibraryEntry& entry);

/// "approved", "target missed" ...; empty where there is nothing to report.
QString stateText(const LibraryEntry& entry);

}  // namespace mocapress
