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

/// The rows of a study as curves and as a table, for one clip or all. A row chosen in one is
/// selected in the other, too.
class StudyResults : public QWidget {
  Q_OBJECT

 public:
  explicit StudyResults(StudyRowsModel* model, QWidget* parent = nullptr);

  /// Sets the clips whose rows are all measured, by path. The average is over these clips.
  void setComplete(const std::set<std::string>& complete);

  /// Sets the compressed clip that is open in the studio: the path of its original, and its point
  /// in the plot.
  void setHere(const QString& path, const std::optional<CurvePoint>& here);

  void setHint(const QString& hint);

  /// Adds a tool to the right of the clip chooser.
  void addTool(QWidget* tool);

  /// Path of the clip that is shown; empty: the average over all.
  QString clip() const;
  void setClip(const QString& path);

  RatePlot* plot() { return plot_; }
  QTreeView* table() { return table_; }

 signals:
  /// The user wants to open this row in the studio.
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
  QTimer update_;  // gathers many rows into one update
  std::set<std::string> complete_;
  QString here_path_;
  std::optional<CurvePoint> here_;
};

}  // namespace mocapress
