// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <set>
#include <string>

#include "core/report/curve.h"

class QComboBox;
class QTreeView;

namespace mocapress {

class RatePlot;
class StudyRowsModel;

/// The rows of a study as curves and as a table, of one clip or of all. What is chosen in one is
/// shown in the other.
class StudyResults : public QWidget {
  Q_OBJECT

 public:
  explicit StudyResults(StudyRowsModel* model, QWidget* parent = nullptr);

  /// Paths of clips of which all rows are there: these make the average.
  void setComplete(const std::set<std::string>& complete);

  /// The compressed clip that is open in the studio: its original's path and what it came to.
  void setHere(const QString& path, const std::optional<CurvePoint>& here);

  void setHint(const QString& hint);

  /// To the right of the chooser of clips.
  void addTool(QWidget* tool);

  /// Path of the clip that is shown; empty: the average over all.
  QString clip() const;
  void setClip(const QString& path);

  RatePlot* plot() { return plot_; }
  QTreeView* table() { return table_; }

 signals:
  /// To be loaded into the studio.
  void rowChosen(int row);

 private:
  void makeTable();
  void fillChooser();
  void showClip();
  void updateLater();
  void update();
  void choose(int row);

  StudyRowsModel* model_;
  QSortFilterProxyModel sorted_;
  RatePlot* plot_;
  QTreeView* table_;
  QComboBox* chooser_;
  QWidget* tools_;
  QTimer update_;  // once for many rows
  std::set<std::string> complete_;
  QString here_path_;
  std::optional<CurvePoint> here_;
};

}  // namespace mocapress
