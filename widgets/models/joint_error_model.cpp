// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/joint_error_model.h"

#include <cassert>

#include "widgets/models/colours.h"
#include "widgets/models/display_names.h"
#include "widgets/models/error_colour.h"
#include "widgets/models/number_text.h"

namespace mocapress {

void JointErrorModel::setLandmarks(std::vector<Landmark> points,
                                   const std::string& shared_namespace) {
  beginResetModel();
  points_ = std::move(points);
  unshown_ = QString::fromStdString(shared_namespace).size();
  distances_.resize(0, 2);
  joint_degrees_.resize(0);
  times_noticed_.resize(0);
  skin_.resize(0, 2);
  endResetModel();
}

void JointErrorModel::setErrors(const Distortion* errors, const SightTable* sight) {
  times_noticed_.resize(0);
  if (sight && sight->windows() > 0)
    times_noticed_ = sight->times_noticed.colwise().maxCoeff().transpose();
  if (!errors || errors->distances.size() == 0) {
    distances_.resize(0, 2);
    joint_degrees_.resize(0);
    skin_.resize(0, 2);
  } else {
    const Eigen::MatrixXf& distances = errors->distances;
    assert(distances.cols() == rowCount());
    distances_.resize(distances.cols(), 2);
    distances_.col(0) = distances.colwise().mean().transpose();
    distances_.col(1) = distances.colwise().maxCoeff().transpose();
    joint_degrees_ = errors->joint_degrees;
    skin_ = errors->skin_of_joints;
  }
  if (rowCount() > 0) emit dataChanged(index(0, Mean), index(rowCount() - 1, SkinMax));
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
      return name.mid(unshown_);
    case Qt::ToolTipRole:  // the full name
      return name;
    case kSortRole:
      return row;  // keeps the skeleton's order
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
  const std::optional<double> error = errorAt(row, column);
  if (role == kSortRole) return error.value_or(-1);
  if (role == Qt::DecorationRole && column == Seen && error) return sightColour(sight_of(*error));
  if (role == Qt::ToolTipRole && column == Seen && error) return displayName(sight_of(*error));
  if (role == Qt::ToolTipRole && column == SkinMax && error)
    return tr("RMS %1").arg(errorText(skin_(jointOf(row), 0), ErrorQuantity::Distance));
  if (role != Qt::DisplayRole) return {};
  if (!error) return QStringLiteral("–");
  if (column == Seen) return QStringLiteral("%1×").arg(shownShort(*error));
  return errorText(*error, column == Angle ? ErrorQuantity::Angle : ErrorQuantity::Distance);
}

std::optional<double> JointErrorModel::errorAt(int row, int column) const {
  if (column == Seen)
    return times_noticed_.size() > 0
               ? std::optional(static_cast<double>(times_noticed_(jointOf(row))))
               : std::nullopt;
  if (distances_.rows() == 0) return std::nullopt;
  if (column == Angle) return joint_degrees_(jointOf(row));
  if (column == SkinMax) {
    const bool carries = skin_.rows() > 0 && skin_(jointOf(row), 1) >= 0;
    return carries ? std::optional(skin_(jointOf(row), 1)) : std::nullopt;
  }
  return static_cast<double>(distances_(row, column - Mean));
}

/// Title and explanation of a column.
std::pair<QString, QString> JointErrorModel::headerTexts(int column) {
  switch (column) {
    case Name:
      return {tr("Joint"), tr("Joint origins and bone ends, in the skeleton's order.")};
    case Mean:
      return {tr("Mean"), tr("World-space distance from the original, mean over the clip.")};
    case Max:
      return {tr("Max"), tr("Largest world-space distance from the original at any frame.")};
    case SkinMax:
      return {
          tr("Skin"),
          tr("Largest error at any frame of the part of the mesh that mainly follows this joint.")};
    case Seen:
      return {tr("Seen"), tr("The joint's most visible error, as a multiple of the noticeable "
                             "error: up to 1 is not visible, up to 2 borderline.")};
    default:
      return {tr("Angle"), tr("Angle between the joint's world-space rotation and the original's, "
                              "RMS over the clip. Bone ends turn with their joint.")};
  }
}

bool JointErrorModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != Name || role != Qt::CheckStateRole) return false;
  emit checkRequested(nameOf(index.row()), value.toInt() == Qt::Checked);
  return true;
}

QVariant JointErrorModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  switch (role) {
    case Qt::DisplayRole:
      return headerTexts(section).first;
    case Qt::ToolTipRole:
      return headerTexts(section).second;
    case Qt::TextAlignmentRole:
      return QVariant((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
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
