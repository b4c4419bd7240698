// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/metrics/distortion.h"
#include "widgets/models/curve_selection.h"

namespace mocapress {

/// One row a landmark: its name, checkable, and its mean and greatest error (cm).
class JointErrorModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Mean, Max, kColumns };
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  /// Rows in the order of `points`, errors unknown.
  void setLandmarks(std::vector<Landmark> points);

  /// frames x landmarks, cm; an empty matrix: unknown.
  void setDistances(const Eigen::MatrixXf& distances);

  void setSelection(const CurveSelection& selection);

  int jointOf(int row) const { return points_[static_cast<std::size_t>(row)].joint; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// A check box was clicked; setSelection() answers.
  void checkRequested(const QString& name, bool checked);

 private:
  QString nameOf(int row) const;
  QVariant nameData(int row, int role) const;
  QVariant errorData(int row, int column, int role) const;

  std::vector<Landmark> points_;
  Eigen::MatrixX2f errors_;  // cm: mean, max; no rows: unknown
  CurveSelection selection_;
};

}  // namespace mocapress
