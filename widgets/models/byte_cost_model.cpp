// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/byte_cost_model.h"

#include <QFont>
#include <algorithm>
#include <string_view>

namespace mocapress {
namespace {

/// The name shown for a part of ByteCosts::rest.
QString partName(std::string_view name) {
  if (name == "skeleton") return ByteCostModel::tr("Skeleton");
  if (name == "description") return ByteCostModel::tr("Description of the clip");
  if (name == "segments") return ByteCostModel::tr("Table of segments");
  if (name == "correction") return ByteCostModel::tr("Chains of the IK correction");
  if (name == "first and last pose") return ByteCostModel::tr("First and last pose");
  if (name == "turned axes") return ByteCostModel::tr("Turned axes");
  if (name == "tracks") return ByteCostModel::tr("Tracks");
  if (name == "scale and rounding") return ByteCostModel::tr("Rounding of the coder");
  if (name == "motion") return ByteCostModel::tr("Motion (cannot be divided)");
  if (name == "section heads") return ByteCostModel::tr("Frame of the file");
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

}  // namespace

void ByteCostModel::setCosts(const std::shared_ptr<const ByteCosts>& costs,
                             std::vector<QString> joints) {
  beginResetModel();
  rows_.clear();
  joints_ = 0;
  if (costs) {
    const Eigen::RowVectorXd of_joints = costs->by_joint();
    for (Eigen::Index j = 0; j < of_joints.size(); ++j)
      rows_.push_back({joints[static_cast<std::size_t>(j)], of_joints(j)});
    joints_ = static_cast<int>(rows_.size());
    for (const ByteCosts::Part& part : costs->rest)
      rows_.push_back({partName(part.name), part.bytes});
    all_ = std::max(1.0, static_cast<double>(costs->file_bytes));
  }
  endResetModel();
}

int ByteCostModel::jointOf(int row) const {
  return row < joints_ ? row : -1;
}

int ByteCostModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ByteCostModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant ByteCostModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool is_name = index.column() == Name;
  switch (role) {
    case Qt::DisplayRole:
      if (is_name) return row.name;
      return index.column() == Bytes ? QStringLiteral("%L1").arg(row.bytes, 0, 'f', 0)
                                     : tr("%L1 %").arg(100 * row.bytes / all_, 0, 'f', 1);
    case kSortRole:
      return is_name ? QVariant(index.row()) : QVariant(row.bytes);
    case Qt::TextAlignmentRole:
      return QVariant((is_name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::FontRole: {
      QFont font;
      font.setItalic(jointOf(index.row()) < 0);
      return font;
    }
    default:
      return {};
  }
}

QVariant ByteCostModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && section == Bytes)
    return tr(
        "Bytes of the file that code this joint, as the decoder counts them. Rows in italics "
        "belong to no joint.");
  if (role != Qt::DisplayRole) return {};
  return section == Name ? tr("Joint") : section == Bytes ? tr("Bytes") : tr("Share");
}

}  // namespace mocapress
