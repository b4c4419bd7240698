// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_tree.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

namespace mocapress {

/// A node of the tree; its rows are folders, then clips.
struct LibraryTree::Folder {
  QString name;
  QString path;
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

  /// Merges a folder with its only subfolder when it holds nothing else.
  void shorten() {
    while (clips.empty() && folders.size() == 1) {
      const std::unique_ptr<Folder> only = std::move(folders.front());
      name = name.isEmpty() || !above ? only->name : name + QLatin1Char('/') + only->name;
      path = only->path;
      clips = std::move(only->clips);
      folders = std::move(only->folders);
    }
    std::sort(folders.begin(), folders.end(),
              [](const auto& a, const auto& b) { return a->name < b->name; });
    for (std::size_t i = 0; i < folders.size(); ++i) {
      folders[i]->above = this;
      folders[i]->row = static_cast<int>(i);
      folders[i]->shorten();
    }
  }

  void collect(std::vector<int>& all) const {
    for (const auto& each : folders) each->collect(all);
    all.insert(all.end(), clips.begin(), clips.end());
  }
};

LibraryTree::LibraryTree(LibraryModel* clips, QObject* parent)
    : QAbstractItemModel(parent), clips_(clips) {
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
  for (int clip = 0; clip < clips_->rowCount(); ++clip) {
    if (!matches(clip)) continue;
    Folder* folder = root_.get();
    const QString path = QFileInfo(clips_->entry(clip).path).path();
    for (const QString& name : path.split(QLatin1Char('/'), Qt::SkipEmptyParts))
      folder = &folder->child(name);
    folder->clips.push_back(clip);
  }
  root_->shorten();
  holders_.assign(static_cast<std::size_t>(clips_->rowCount()), nullptr);
  const auto note = [this](auto&& self, Folder& folder) -> void {
    QStringList names;
    for (const int clip : folder.clips) {
      holders_[static_cast<std::size_t>(clip)] = &folder;
      names << QFileInfo(clips_->entry(clip).path).fileName();
    }
    folder.shared = sharedName(names);
    for (const auto& each : folder.folders) self(self, *each);
  };
  note(note, *root_);
  endResetModel();
}

bool LibraryTree::matches(int clip) const {
  const QString text = clips_->entry(clip).path + QLatin1Char(' ') +
                       clips_->index(clip).data(Qt::AccessibleTextRole).toString();
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

void LibraryTree::setFilter(const QString& words) {
  words_ = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  build();
}

void LibraryTree::clipsChanged(int first, int last) {
  for (int clip = first; clip <= last; ++clip) {
    const bool is_there = holders_[static_cast<std::size_t>(clip)] != nullptr;
    if (is_there != matches(clip)) return build();
  }
  for (int clip = first; clip <= last; ++clip)
    for (QModelIndex at = indexOf(clip); at.isValid(); at = at.parent()) emit dataChanged(at, at);
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
  const Folder* folder = folderAt(parent);
  return folder ? static_cast<int>(folder->folders.size() + folder->clips.size()) : 0;
}

int LibraryTree::clipOf(const QModelIndex& index) const {
  if (!index.isValid() || folderAt(index)) return -1;
  const Folder* holder = holderOf(index);
  return holder->clips[static_cast<std::size_t>(index.row()) - holder->folders.size()];
}

QModelIndex LibraryTree::indexOf(int clip) const {
  if (clip < 0 || clip >= static_cast<int>(holders_.size())) return {};
  Folder* holder = holders_[static_cast<std::size_t>(clip)];
  if (!holder) return {};
  const auto place = std::find(holder->clips.begin(), holder->clips.end(), clip);
  const auto row =
      static_cast<std::ptrdiff_t>(holder->folders.size()) + (place - holder->clips.begin());
  return createIndex(static_cast<int>(row), 0, holder);
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
  const auto missed = std::count_if(clips.begin(), clips.end(), [this](int clip) {
    const LibraryEntry& entry = clips_->entry(clip);
    return entry.missing || !entry.trouble.isEmpty() || (entry.outcome && !entry.outcome->met);
  });
  const QString count = tr("%Ln clip(s)", nullptr, static_cast<int>(clips.size()));
  return missed == 0 ? count : tr("%1, %L2 missed").arg(count).arg(missed);
}

QVariant LibraryTree::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Folder* folder = folderAt(index);
  if (!folder) return clips_->index(clipOf(index)).data(role);
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
