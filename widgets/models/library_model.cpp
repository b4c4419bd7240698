// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_model.h"

#include <QFileInfo>
#include <QStringList>

#include "widgets/models/number_text.h"

namespace mocapress {

QString outcomeText(const LibraryEntry& entry) {
  if (!entry.trouble.isEmpty()) return LibraryModel::tr("Cannot be read");
  if (!entry.outcome)
    return entry.frames == 0 ? LibraryModel::tr("Reading…")
                             : LibraryModel::tr("%Ln frame(s)", nullptr, entry.frames);
  return LibraryModel::tr("%L1 : 1, %2")
      .arg(entry.outcome->ratio, 0, 'f', 1)
      .arg(lengthText(entry.outcome->eps_cm));
}

QString stateText(const LibraryEntry& entry) {
  if (entry.verdict == Verdict::Approved) return LibraryModel::tr("✓ approved");
  if (entry.verdict == Verdict::Rejected) return LibraryModel::tr("✕ rejected");
  if (!entry.outcome) return {};
  return entry.outcome->met ? LibraryModel::tr("target met") : LibraryModel::tr("! target missed");
}

void LibraryModel::setEntries(std::vector<LibraryEntry> entries) {
  beginResetModel();
  entries_ = std::move(entries);
  endResetModel();
}

int LibraryModel::rowOf(const QString& path) const {
  for (int row = 0; row < rowCount(); ++row)
    if (entry(row).path == path) return row;
  return -1;
}

void LibraryModel::setEntry(const LibraryEntry& entry) {
  const int row = rowOf(entry.path);
  if (row < 0) {
    beginInsertRows({}, rowCount(), rowCount());
    entries_.push_back(entry);
    endInsertRows();
    return;
  }
  entries_[static_cast<std::size_t>(row)] = entry;
  emit dataChanged(index(row), index(row));
}

void LibraryModel::addEntries(const std::vector<LibraryEntry>& entries) {
  if (entries.empty()) return;
  beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(entries.size()) - 1);
  entries_.insert(entries_.end(), entries.begin(), entries.end());
  endInsertRows();
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LibraryEntry& shown = entry(index.row());
  const QString name = QFileInfo(shown.path).fileName();
  switch (role) {
    case Qt::DisplayRole:
      return name;
    case Qt::AccessibleTextRole: {
      QStringList parts = {name, outcomeText(shown), stateText(shown)};
      parts.removeAll(QString());
      return parts.join(QStringLiteral(", "));
    }
    case Qt::ToolTipRole: {
      QStringList lines = {shown.path, shown.trouble, shown.note};
      lines.removeAll(QString());
      return lines.join(QLatin1Char('\n'));
    }
    default:
      return {};
  }
}

}  // namespace mocapress
