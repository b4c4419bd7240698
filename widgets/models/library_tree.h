// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <vector>

#include "widgets/models/library_columns.h"
#include "widgets/models/library_filter.h"
#include "widgets/models/library_groups.h"
#include "widgets/models/library_model.h"
#include "widgets/models/shared_name.h"

namespace mocapress {

/// The clips of a library that match a filter, in the filter's order, as a tree of folders or other
/// groups. Folders that all clips share are left out. A folder that holds only one folder is joined
/// with it.
class LibraryTree : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit LibraryTree(LibraryModel* clips, QObject* parent = nullptr);
  ~LibraryTree() override;

  /// See LibraryFilter.
  void setFilter(const QString& words);
  void setShow(LibraryShow show);
  void sort(int column, Qt::SortOrder order) override;

  void setGrouping(Grouping grouping);

  const LibraryFilter* filter() const { return &filter_; }

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
  int columnCount(const QModelIndex& = {}) const override { return kLibraryColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Folder;

  void build();
  Folder* holderOf(const QModelIndex& index) const;  // the folder that has the index as a row
  Folder* folderAt(const QModelIndex& index) const;  // null: a clip
  void clipsChanged(int first, int last);

  LibraryModel* clips_;
  LibraryFilter filter_;
  Grouping grouping_ = Grouping::Folder;
  std::unique_ptr<Folder> root_;

  /// A clip's place in the filter and in its folder, as of the last build().
  struct Place {
    int row = -1;  // -1: filtered out
    Folder* folder = nullptr;
    QString group;      // name of its group
    int in_folder = 0;  // index among the folder's clips
  };
  std::vector<Place> places_;  // one for each clip
};

}  // namespace mocapress
