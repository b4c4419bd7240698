// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <QString>
#include <optional>
#include <vector>

namespace mocapress {

/// A row of the list of pinned results.
struct PinnedEntry {
  QString name;
  QColor colour;
  double ratio = 0;
  double eps_cm = 0;
  double p95_cm = 0;
  double max_cm = 0;
  std::optional<double> drift_cm;
};

/// A table with one row for each pinned result: its editable name and its measurements.
class PinnedModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Ratio, Eps, P95, Max, Footskate, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  void setEntries(std::vector<PinnedEntry> entries);
  const std::vector<PinnedEntry>& entries() const { return entries_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// A name was edited; the owner answers by setEntries().
  void nameEdited(int row, const QString& name);

 private:
  std::vector<PinnedEntry> entries_;
};

}  // namespace mocapress
