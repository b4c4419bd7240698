// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "core/codec/encode/encoder.h"
#include "core/codec/encode/options/importance.h"
#include "core/motion/body_part.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace mocapress {

class FactorControl;

/// Edits how important errors are: sliders for body parts and standing feet, and a drawer for any
/// joint. Shows what is set and reports what the user chooses.
class ImportancePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ImportancePanel(QWidget* parent = nullptr);

  /// Sets the skeleton, with all joints equally important.
  void setSkeleton(const Skeleton& skeleton);

  /// Sets importances for the skeleton's joints. Emits nothing.
  void setImportance(const Importance& importance);

  /// Disables the panel for methods that ignore importances.
  void setMethod(Method method);

  FactorControl* part(BodyPart part) const { return parts_.at(part); }
  FactorControl* contacts() const { return contacts_; }
  QToolButton* drawer() const { return drawer_; }
  QTreeWidget* joints() const { return joints_; }
  QLineEdit* finder() const { return find_; }
  QPushButton* even() const { return even_; }

 signals:
  void importanceChanged(const Importance& importance);

 private:
  void makeJoints();
  void choosePart(BodyPart part, double factor);
  void chooseJoint(QTreeWidgetItem* item);
  void find(const QString& text);
  void tell();
  void show();

  Skeleton skeleton_;
  Importance importance_;
  bool showing_ = false;
  QLabel* note_;
  std::map<BodyPart, FactorControl*> parts_;
  FactorControl* contacts_;
  QToolButton* drawer_;
  QWidget* drawn_;  // content of the drawer
  QLineEdit* find_;
  QTreeWidget* joints_;
  QPushButton* even_;
};

}  // namespace mocapress
