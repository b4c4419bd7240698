// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <vector>

#include "widgets/models/library_model.h"
#include "widgets/models/shared_name.h"

namespace mocapress {

/// The clips of a library below their folders, as far as they match a filter. Folders that all
/// clips share are left out, and so are those between with nothing but one folder in them.
class LibraryTree : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit LibraryTree(LibraryModel* clips, QObject* parent = nullptr);
  ~LibraryTree() override;

  /// Words that name, folder or state must all have; empty: everything is there.
  void setFilter(const QString& words);

  /// Of the library; -1: a folder.
  int clipOf(const QModelIndex& index) const;
  QModelIndex indexOf(int clip) const;  // invalid: it is filtered out

  /// Of a folder, however deep below; of a clip: itself.
  std::vector<int> clipsBelow(const QModelIndex& index) const;

  /// The part of a clip's name that the names of all clips beside it share.
  SharedName sharedNameOf(const QModelIndex& index) const;

  /// Full path; empty: a clip.
  QString folderPath(const QModelIndex& index) const;

  /// "12 clips, 2 missed".
  QString folderSummary(const QModelIndex& index) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex&) const override { return 1; }
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  struct Folder;

  void build();
  bool matches(int clip) const;
  Folder* holderOf(const QModelIndex& index) const;  // the folder the index is a row of
  Folder* folderAt(const QModelIndex& index) const;  // null: a clip
  void clipsChanged(int first, int last);

  LibraryModel* clips_;
  QStringList words_;
  std::unique_ptr<Folder> root_;
  std::vector<Folder*> holders_;  // of each clip; null: filtered out
};

}  // namespace mocapress
