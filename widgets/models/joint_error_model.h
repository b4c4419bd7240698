// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/metrics/visibility.h"
#include "widgets/models/curve_selection.h"

namespace mocapress {

/// A table with one row for each landmark: its checkable name, mean and largest distance from the
/// original (cm), angle error (degrees), visibility, and the largest distance of the skin that its
/// joint carries.
class JointErrorModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Mean, Max, Angle, Seen, SkinMax, kColumns };
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  /// Makes a row for each of `points`, without errors. Names are shown without the prefix
  /// `shared_namespace`.
  void setLandmarks(std::vector<Landmark> points, const std::string& shared_namespace = {});

  /// Sets the errors of the landmarks given to setLandmarks(); null: unknown.
  void setErrors(const Distortion* errors, const SightTable* sight);

  /// True when there are errors of a skin.
  bool hasSkin() const { return skin_.rows() > 0; }

  void setSelection(const CurveSelection& selection);

  int jointOf(int row) const { return points_[static_cast<std::size_t>(row)].joint; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// A check box was clicked; the owner answers by setSelection().
  void checkRequested(const QString& name, bool checked);

 private:
  static std::pair<QString, QString> headerTexts(int column);
  QString nameOf(int row) const;
  QVariant nameData(int row, int role) const;
  QVariant errorData(int row, int column, int role) const;
  std::optional<double> errorAt(int row, int column) const;

  std::vector<Landmark> points_;
  qsizetype unshown_ = 0;          // length of the prefix that is not shown
  Eigen::MatrixX2f distances_;     // cm, columns mean and max; no rows: unknown
  Eigen::VectorXd joint_degrees_;  // RMS angle of each joint
  Eigen::VectorXf times_noticed_;  // worst of each joint, in noticeable thresholds; empty: unknown
  Eigen::MatrixX2d skin_;          // laid out as Distortion::skin_of_joints
  CurveSelection selection_;
};

}  // namespace mocapress
