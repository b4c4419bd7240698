// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/feet/footskate.h"

namespace mocapress {

/// A table with one row for each footskate finding, largest drift first: the point, the frames, the
/// drift, the slide and the speed.
class SlideModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Joint, Frames, Drift, Slid, Speed, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  /// `names` has the names of all landmarks, by index.
  void setFindings(std::vector<SlideFinding> findings, const std::vector<QString>& names);

  const SlideFinding& finding(int row) const { return findings_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<SlideFinding> findings_;
  std::vector<QString> names_;
};

}  // namespace mocapress
