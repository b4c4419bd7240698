// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/joint_error_model.h"

#include <cassert>

#include "widgets/models/length_text.h"

namespace mocapress {

void JointErrorModel::setLandmarks(std::vector<Landmark> points) {
  beginResetModel();
  points_ = std::move(points);
  errors_.resize(0, 2);
  endResetModel();
}

void JointErrorModel::setDistances(const Eigen::MatrixXf& distances) {
  if (distances.size() == 0) {
    errors_.resize(0, 2);
  } else {
    assert(distances.cols() == rowCount());
    errors_.resize(distances.cols(), 2);
    errors_.col(0) = distances.colwise().mean().transpose();
    errors_.col(1) = distances.colwise().maxCoeff().transpose();
  }
  if (rowCount() > 0) emit dataChanged(index(0, Mean), index(rowCount() - 1, Max));
}

void JointErrorModel::setSelection(const CurveSelection& selection) {
  selection_ = selection;
  if (rowCount() > 0) emit dataChanged(index(0, Name), index(rowCount() - 1, Name));
}

int JointErrorModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(points_.size());
}

int JointErrorModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QString JointErrorModel::nameOf(int row) const {
  return QString::fromStdString(points_[static_cast<std::size_t>(row)].name);
}

QVariant JointErrorModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  return index.column() == Name ? nameData(index.row(), role)
                                : errorData(index.row(), index.column(), role);
}

QVariant JointErrorModel::nameData(int row, int role) const {
  const QString name = nameOf(row);
  switch (role) {
    case Qt::DisplayRole:
      return name;
    case kSortRole:
      return row;  // the skeleton's order
    case Qt::CheckStateRole:
      return selection_.contains(name) ? Qt::Checked : Qt::Unchecked;
    case Qt::DecorationRole:
      return selection_.contains(name) ? selection_.colour(name) : QColor(Qt::transparent);
    default:
      return {};
  }
}

QVariant JointErrorModel::errorData(int row, int column, int role) const {
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  const bool known = errors_.rows() > 0;
  const double cm = known ? errors_(row, column - Mean) : -1;
  if (role == kSortRole) return cm;
  if (role == Qt::DisplayRole) return known ? lengthText(cm) : QStringLiteral("–");
  return {};
}

bool JointErrorModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != Name || role != Qt::CheckStateRole) return false;
  emit checkRequested(nameOf(index.row()), value.toInt() == Qt::Checked);
  return true;
}

QVariant JointErrorModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const bool is_name = section == Name;
  switch (role) {
    case Qt::DisplayRole:
      return is_name ? tr("Joint") : section == Mean ? tr("Mean") : tr("Max");
    case Qt::ToolTipRole:
      return is_name ? tr("Joint origins and bone ends, in the skeleton's order.")
             : section == Mean
                 ? tr("Distance in the world from the original, averaged over the clip.")
                 : tr("Greatest distance in the world from the original, at any frame.");
    case Qt::TextAlignmentRole:
      return QVariant((is_name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
      return {};
  }
}

Qt::ItemFlags JointErrorModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (index.isValid() && index.column() == Name) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

}  // namespace mocapress
