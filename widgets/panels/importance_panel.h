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

/// What the encoder is to take more care of: parts of the body and standing feet on sliders, and
/// any joint in a drawer. Shows what it is told, and tells what the user chose.
class ImportancePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ImportancePanel(QWidget* parent = nullptr);

  /// Its joints, all alike.
  void setSkeleton(const Skeleton& skeleton);

  /// Those of the skeleton. Emits nothing.
  void setImportance(const Importance& importance);

  /// Not every method heeds it.
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
  QWidget* drawn_;  // what is in the drawer
  QLineEdit* find_;
  QTreeWidget* joints_;
  QPushButton* even_;
};

}  // namespace mocapress
