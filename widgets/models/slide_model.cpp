// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/slide_model.h"

#include <QLocale>
#include <algorithm>

#include "widgets/models/number_text.h"

namespace mocapress {

void SlideModel::setFindings(std::vector<SlideFinding> findings,
                             const std::vector<QString>& names) {
  beginResetModel();
  findings_ = std::move(findings);
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const auto& a, const auto& b) { return a.drift_cm > b.drift_cm; });
  names_ = names;
  endResetModel();
}

int SlideModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(findings_.size());
}

int SlideModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant SlideModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((index.column() == Joint ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const SlideFinding& slide = finding(index.row());
  switch (index.column()) {
    case Joint:
      return names_[static_cast<std::size_t>(slide.span.landmark)];
    case Frames:  // counts from 1, as the transport bar does
      return tr("%L1–%L2").arg(slide.span.first_frame + 1).arg(slide.span.last_frame + 1);
    case Drift:
      return lengthText(slide.drift_cm);
    case Slid:
      return surplusText(slide.slid_cm);
    case Speed:
      return QLocale().toString(slide.worst_speed_cm_s, 'f', 0);
    default:
      return {};
  }
}

QVariant SlideModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((section == Joint ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  switch (section) {
    case Joint:
      return role == Qt::DisplayRole ? QVariant(tr("Joint")) : QVariant();
    case Frames:
      return role == Qt::DisplayRole ? QVariant(tr("Frames"))
             : role == Qt::ToolTipRole
                 ? QVariant(tr("Frames in which the foot of the original stands on the ground."))
                 : QVariant();
    case Drift:
      return role == Qt::DisplayRole ? QVariant(tr("Drift"))
             : role == Qt::ToolTipRole
                 ? QVariant(tr("Largest distance between the foot and its place in the original."))
                 : QVariant();
    case Slid:
      return role == Qt::DisplayRole ? QVariant(tr("Path"))
             : role == Qt::ToolTipRole
                 ? QVariant(tr("Path of the foot over the ground beyond the original's. A foot "
                               "that trembles in place has a long path."))
                 : QVariant();
    case Speed:
      return role == Qt::DisplayRole   ? QVariant(tr("cm/s"))
             : role == Qt::ToolTipRole ? QVariant(tr("Highest speed over the ground."))
                                       : QVariant();
    default:
      return {};
  }
}

}  // namespace mocapress
