// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/pinned_model.h"

#include <QLocale>

#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

QString textOf(const PinnedEntry& entry, int column) {
  const auto number = [](double value, int digits) {
    return QLocale().toString(value, 'f', digits);
  };
  switch (column) {
    case PinnedModel::Name:
      return entry.name;
    case PinnedModel::Ratio:
      return number(entry.ratio, 1);
    case PinnedModel::Eps:
      return lengthText(entry.eps_cm);
    case PinnedModel::P95:
      return lengthText(entry.p95_cm);
    case PinnedModel::Max:
      return lengthText(entry.max_cm);
    case PinnedModel::Footskate:
      return entry.drift_cm ? lengthText(*entry.drift_cm) : QStringLiteral("–");
    default:
      return {};
  }
}

}  // namespace

void PinnedModel::setEntries(std::vector<PinnedEntry> entries) {
  if (entries.size() == entries_.size()) {  // keeps the selected row
    entries_ = std::move(entries);
    if (!entries_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  entries_ = std::move(entries);
  endResetModel();
}

int PinnedModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int PinnedModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant PinnedModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PinnedEntry& entry = entries_[static_cast<std::size_t>(index.row())];
  const bool is_name = index.column() == Name;
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return textOf(entry, index.column());
    case Qt::ToolTipRole:
      return is_name ? QVariant(entry.name) : QVariant();
    case Qt::DecorationRole:
      return is_name ? QVariant(entry.colour) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant((is_name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
      return {};
  }
}

bool PinnedModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const QString name = value.toString().trimmed();
  if (!index.isValid() || index.column() != Name || role != Qt::EditRole || name.isEmpty())
    return false;
  emit nameEdited(index.row(), name);
  return true;
}

QVariant PinnedModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  const bool shown = role == Qt::DisplayRole;
  if (!shown && role != Qt::ToolTipRole) return {};
  switch (section) {
    case Name:
      return shown ? tr("Result") : tr("Double click to give it another name.");
    case Ratio:
      return shown ? tr("Ratio") : tr("Compression ratio");
    case Eps:
      return shown ? tr("eps_x") : tr("Weighted root mean square distance from the original.");
    case P95:
      return shown ? tr("p95") : tr("95 % of all points at all frames have at most this error.");
    case Max:
      return shown ? tr("Max") : tr("Largest error of any point at any frame.");
    case Footskate:
      return shown ? tr("Drift")
                   : tr("Largest distance between a standing foot and its place in the original.");
    default:
      return {};
  }
}

Qt::ItemFlags PinnedModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (index.isValid() && index.column() == Name) flags |= Qt::ItemIsEditable;
  return flags;
}

}  // namespace mocapress
