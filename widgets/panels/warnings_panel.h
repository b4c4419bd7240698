// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <map>

#include "core/base/error.h"

class QPlainTextEdit;
class QToolButton;

namespace mocapress {

class ElidedLabel;

/// Tells what a reader repaired or guessed, in a line that unfolds and can be dismissed, once a
/// clip: from then on the mark on the clip's row in the library has it.
class WarningsPanel : public QFrame {
  Q_OBJECT

 public:
  explicit WarningsPanel(QWidget* parent = nullptr);

  /// `clip` is its path. No warnings, or those that were told of it already, hide the panel.
  void setWarnings(const QString& clip, const Warnings& warnings);

 private:
  ElidedLabel* title_;
  QToolButton* unfold_;
  QPlainTextEdit* list_;
  QString clip_;
  std::map<QString, QStringList> told_;  // by clip
};

}  // namespace mocapress
