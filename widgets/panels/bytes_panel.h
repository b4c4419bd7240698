// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;
class QTreeWidget;

namespace mocapress {

class ByteCostModel;

/// A change of the settings, and its effect when it was tried.
struct SlopeRow {
  QString change;         // such as "Fingers at twice the error"
  double bytes = 0;       // bytes that the change adds to the motion
  double error_cm = 0;    // error of the changed part, before
  double becomes_cm = 0;  // error of the changed part, after
};

/// Bytes by joint in a sortable list with bars, and beside it the effects of other settings.
class BytesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit BytesPanel(ByteCostModel* model, QWidget* parent = nullptr);

  /// Makes the joint's row current. Emits nothing.
  void setCurrentJoint(int joint);

  /// Shows the effects of other settings; applyRequested() counts them in this order. The chosen
  /// line stays chosen when more lines come.
  void setSlopes(const std::vector<SlopeRow>& slopes);

  /// `measuring`: more results will come. `possible`: there is a clip to measure on.
  void setState(bool measuring, bool possible);

  QPushButton* measure() const { return measure_; }
  QPushButton* apply() const { return apply_; }
  QTreeWidget* slopes() const { return slopes_; }

 signals:
  void currentJointChanged(int joint);
  void measureRequested();
  void applyRequested(int slope);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeSlopes();

  ByteCostModel* model_;
  QSortFilterProxyModel* sorted_;
  QTreeView* view_;
  QTreeWidget* slopes_;
  QLabel* hint_;
  QPushButton* measure_;
  QPushButton* apply_;
};

}  // namespace mocapress
