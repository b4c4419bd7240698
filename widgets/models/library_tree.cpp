// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_tree.h"

#include <QDir>
#include <QHash>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace mocapress {

/// A node of the tree. Its rows are its folders, then its clips.
struct LibraryTree::Folder {
  QString name;
  QString path;
  double rank = 0;
  Folder* above = nullptr;
  int row = 0;  // row among the folders of `above`
  std::vector<std::unique_ptr<Folder>> folders;
  std::vector<int> clips;
  SharedName shared;  // shared part of the names of `clips`

  Folder& child(const QString& child_name) {
    for (const auto& each : folders)
      if (each->name == child_name) return *each;
    auto made = std::make_unique<Folder>();
    made->name = child_name;
    made->path = path + QLatin1Char('/') + child_name;
    made->above = this;
    folders.push_back(std::move(made));
    return *folders.back();
  }

  /// Sorts folders by rank and name. With `shorten`, joins each folder that holds one folder and
  /// nothing else with that folder.
  void arrange(bool shorten) {
    while (shorten && clips.empty() && folders.size() == 1) {
      const std::unique_ptr<Folder> only = std::move(folders.front());
      name = name.isEmpty() || !above ? only->name : name + QLatin1Char('/') + only->name;
      path = only->path;
      clips = std::move(only->clips);
      folders = std::move(only->folders);
    }
    std::sort(folders.begin(), folders.end(), [](const auto& a, const auto& b) {
      return std::pair(a->rank, a->name) < std::pair(b->rank, b->name);
    });
    for (std::size_t i = 0; i < folders.size(); ++i) {
      folders[i]->above = this;
      folders[i]->row = static_cast<int>(i);
      folders[i]->arrange(shorten);
    }
  }

  void collect(std::vector<int>& all) const {
    for (const auto& each : folders) each->collect(all);
    all.insert(all.end(), clips.begin(), clips.end());
  }
};

/// Connects to the clips after filter_ did, so that the filter is already up to date when the tree
/// receives a change.
LibraryTree::LibraryTree(LibraryModel* clips, QObject* parent)
    : QAbstractItemModel(parent), clips_(clips), filter_(clips) {
  connect(clips, &LibraryModel::modelReset, this, &LibraryTree::build);
  connect(clips, &LibraryModel::rowsInserted, this, &LibraryTree::build);
  connect(clips, &LibraryModel::rowsRemoved, this, &LibraryTree::build);
  connect(clips, &LibraryModel::dataChanged, this,
          [this](const QModelIndex& first, const QModelIndex& last) {
            clipsChanged(first.row(), last.row());
          });
  build();
}

LibraryTree::~LibraryTree() = default;

void LibraryTree::build() {
  beginResetModel();
  root_ = std::make_unique<Folder>();
  places_.assign(static_cast<std::size_t>(clips_->rowCount()), {});
  QHash<QString, Folder*> folders;  // key: name of the group
  for (int row = 0; row < filter_.rowCount(); ++row) {
    const int clip = filter_.clipAt(row);
    const auto [group, rank] = groupOf(clips_->entry(clip), grouping_);
    Folder*& folder = folders[group];
    if (!folder) {
      folder = root_.get();
      const QStringList names =
          grouping_ == Grouping::Folder ? group.split(QLatin1Char('/')) : QStringList(group);
      for (const QString& name : names)
        if (!name.isEmpty()) folder = &folder->child(name);
      folder->rank = rank;
    }
    folder->clips.push_back(clip);
    places_[static_cast<std::size_t>(clip)] = {row, nullptr, group};
  }
  // Grouped by anything but folders, a single group is still shown, since it says something about
  // the clips.
  root_->arrange(grouping_ == Grouping::Folder);
  const auto note = [this](auto&& self, Folder& folder) -> void {
    QStringList names;
    for (const int clip : folder.clips) {
      Place& place = places_[static_cast<std::size_t>(clip)];
      place.folder = &folder;
      place.in_folder = static_cast<int>(names.size());
      names << clips_->entry(clip).name();
    }
    folder.shared = sharedName(names);
    for (const auto& each : folder.folders) self(self, *each);
  };
  note(note, *root_);
  endResetModel();
}

void LibraryTree::setFilter(const QString& words) {
  filter_.setWords(words);
  build();
}

void LibraryTree::setShow(LibraryShow show) {
  filter_.setShow(show);
  build();
}

void LibraryTree::setGrouping(Grouping grouping) {
  grouping_ = grouping;
  build();
}

void LibraryTree::sort(int column, Qt::SortOrder order) {
  filter_.sort(column, order);
  build();
}

void LibraryTree::clipsChanged(int first, int last) {
  // For each changed row, views search from the top for its place: beyond this many rows a reset is
  // faster.
  constexpr int kMany = 1000;
  if (last - first >= kMany) return build();
  for (int clip = first; clip <= last; ++clip) {
    const Place& place = places_[static_cast<std::size_t>(clip)];
    if (place.row != filter_.rowOf(clip) ||
        (place.folder && place.group != groupOf(clips_->entry(clip), grouping_).name))
      return build();
  }
  // Emits one signal for all changed clips of a folder: views search for the row of every signal.
  std::map<Folder*, std::pair<int, int>> rows;  // first and last changed row
  for (int clip = first; clip <= last; ++clip)
    if (const QModelIndex at = indexOf(clip); at.isValid()) {
      const auto [of_folder, is_new] =
          rows.try_emplace(holderOf(at), std::pair(at.row(), at.row()));
      auto& [least, most] = of_folder->second;
      least = std::min(least, at.row());
      most = std::max(most, at.row());
    }
  const auto tell = [this](Folder* folder, int least, int most) {
    emit dataChanged(createIndex(least, 0, folder), createIndex(most, kLibraryColumns - 1, folder));
  };
  std::set<Folder*> summed_up;
  for (const auto& [folder, range] : rows) {
    tell(folder, range.first, range.second);
    for (Folder* each = folder; each->above; each = each->above) summed_up.insert(each);
  }
  for (Folder* folder : summed_up) tell(folder->above, folder->row, folder->row);
}

LibraryTree::Folder* LibraryTree::holderOf(const QModelIndex& index) const {
  return static_cast<Folder*>(index.internalPointer());
}

SharedName LibraryTree::sharedNameOf(const QModelIndex& index) const {
  return holderOf(index)->shared;
}

LibraryTree::Folder* LibraryTree::folderAt(const QModelIndex& index) const {
  if (!index.isValid()) return root_.get();
  const Folder* holder = holderOf(index);
  const auto row = static_cast<std::size_t>(index.row());
  return row < holder->folders.size() ? holder->folders[row].get() : nullptr;
}

QModelIndex LibraryTree::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, folderAt(parent));
}

QModelIndex LibraryTree::parent(const QModelIndex& index) const {
  if (!index.isValid() || !holderOf(index)->above) return {};
  const Folder* holder = holderOf(index);
  return createIndex(holder->row, 0, holder->above);
}

int LibraryTree::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  const Folder* folder = folderAt(parent);
  return folder ? static_cast<int>(folder->folders.size() + folder->clips.size()) : 0;
}

int LibraryTree::clipOf(const QModelIndex& index) const {
  if (!index.isValid() || folderAt(index)) return -1;
  const Folder* holder = holderOf(index);
  return holder->clips[static_cast<std::size_t>(index.row()) - holder->folders.size()];
}

QModelIndex LibraryTree::indexOf(int clip) const {
  if (clip < 0 || clip >= static_cast<int>(places_.size())) return {};
  const Place& place = places_[static_cast<std::size_t>(clip)];
  if (!place.folder) return {};
  return createIndex(static_cast<int>(place.folder->folders.size()) + place.in_folder, 0,
                     place.folder);
}

std::vector<int> LibraryTree::clipsBelow(const QModelIndex& index) const {
  std::vector<int> all;
  if (const Folder* folder = folderAt(index))
    folder->collect(all);
  else
    all.push_back(clipOf(index));
  return all;
}

QString LibraryTree::folderPath(const QModelIndex& index) const {
  const Folder* folder = folderAt(index);
  return folder ? folder->path : QString();
}

QString LibraryTree::folderSummary(const QModelIndex& index) const {
  const std::vector<int> clips = clipsBelow(index);
  const auto missed = std::count_if(clips.begin(), clips.end(),
                                    [this](int clip) { return isMissed(clips_->entry(clip)); });
  const QString count = tr("%Ln clip(s)", nullptr, static_cast<int>(clips.size()));
  return missed == 0 ? count : tr("%1, %L2 missed").arg(count).arg(missed);
}

QVariant LibraryTree::headerData(int section, Qt::Orientation orientation, int role) const {
  return clips_->headerData(section, orientation, role);
}

QVariant LibraryTree::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Folder* folder = folderAt(index);
  if (!folder) return clips_->index(clipOf(index), index.column()).data(role);
  if (index.column() > 0) return {};
  switch (role) {
    case Qt::DisplayRole:
      return folder->name;
    case Qt::ToolTipRole:
      return QDir::toNativeSeparators(folder->path);
    case Qt::AccessibleTextRole:
      return QStringLiteral("%1, %2").arg(folder->name, folderSummary(index));
    default:
      return {};
  }
}

}  // namespace mocapress
