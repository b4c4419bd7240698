// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/study/row.h"

namespace mocapress {

/// The rows of a study as a table that grows.
class StudyRowsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Clip, Method, Asked, Ratio, Eps, Max, Footskate, Seconds, kColumns };
  enum Role { SortRole = Qt::UserRole, ClipPathRole };

  using QAbstractTableModel::QAbstractTableModel;

  void clear();
  void append(const std::vector<StudyRow>& rows);

  const std::vector<StudyRow>& rows() const { return rows_; }
  const StudyRow& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }

  /// Everything known about a row, in a few lines.
  QString description(int index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<StudyRow> rows_;
};

/// Title of the row's series: "Annealed wavelets + IK 16:1".
QString seriesTitle(const StudyRow& row);

/// The file's name without its extension.
QString clipTitle(const StudyRow& row);

/// Formats a target as "30:1" or "0.5 cm".
QString targetText(const Target& target);

}  // namespace mocapress
