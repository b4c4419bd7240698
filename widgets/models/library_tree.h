// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <vector>

#include "widgets/models/library_model.h"
#include "widgets/models/shared_name.h"

namespace mocapress {

/// The clips of a library as a tree of folders, reduced by a filter. Folders that all clips share
/// are left out, and so are folders that hold nothing but one folder.
class LibraryTree : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit LibraryTree(LibraryModel* clips, QObject* parent = nullptr);
  ~LibraryTree() override;

  /// Words that must all occur in name, folder or state; empty: no filter.
  void setFilter(const QString& words);

  /// The clip's row in the library; -1 for a folder.
  int clipOf(const QModelIndex& index) const;
  QModelIndex indexOf(int clip) const;  // invalid: the clip is filtered out

  /// All clips below a folder at any depth; for a clip, the clip itself.
  std::vector<int> clipsBelow(const QModelIndex& index) const;

  /// The part of a clip's name that all clips in its folder share.
  SharedName sharedNameOf(const QModelIndex& index) const;

  /// Full path of a folder; empty for a clip.
  QString folderPath(const QModelIndex& index) const;

  /// Sums up a folder, as in "12 clips, 2 missed".
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
  Folder* holderOf(const QModelIndex& index) const;  // the folder that has the index as a row
  Folder* folderAt(const QModelIndex& index) const;  // null: a clip
  void clipsChanged(int first, int last);

  LibraryModel* clips_;
  QStringList words_;
  std::unique_ptr<Folder> root_;
  std::vector<Folder*> holders_;  // the folder of each clip; null: filtered out
};

}  // namespace mocapress
