// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "core/codec/format/byte_costs.h"

namespace mocapress {

/// A table of a compressed file's bytes: one row for each joint, then one for each other part.
class ByteCostModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Bytes, Share, kColumns };
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  /// Null costs: unknown. `joints` has the names of all joints.
  void setCosts(const std::shared_ptr<const ByteCosts>& costs, std::vector<QString> joints);

  /// The joint of a row; -1: the row is about another part of the file.
  int jointOf(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    QString name;
    double bytes = 0;
  };

  std::vector<Row> rows_;
  int joints_ = 0;  // number of joint rows, which come first
  double all_ = 1;
};

}  // namespace mocapress
