// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "core/base/error.h"

class QLabel;
class QPlainTextEdit;
class QToolButton;

namespace mocapress {

/// What a reader repaired or guessed: one line that unfolds and can be dismissed.
class WarningsPanel : public QFrame {
  Q_OBJECT

 public:
  explicit WarningsPanel(QWidget* parent = nullptr);

  /// None hides the panel.
  void setWarnings(const Warnings& warnings);

 private:
  QLabel* title_;
  QToolButton* unfold_;
  QPlainTextEdit* list_;
};

}  // namespace mocapress
