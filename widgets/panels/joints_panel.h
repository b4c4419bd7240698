// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QSortFilterProxyModel;
class QTreeView;

namespace mocapress {

class JointErrorModel;

/// A sortable list of joints with their errors. Checked joints are drawn as curves; the current
/// joint is highlighted in the 3D view.
class JointsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit JointsPanel(JointErrorModel* model, QWidget* parent = nullptr);

  /// Makes the row of the joint's origin current. Emits nothing.
  void setCurrentJoint(int joint);

 signals:
  void currentJointChanged(int joint);

 private:
  JointErrorModel* model_;
  QSortFilterProxyModel* sorted_;
  QTreeView* view_;
};

}  // namespace mocapress
