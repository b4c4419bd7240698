// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <map>

#include "core/base/error.h"

class QPlainTextEdit;
class QToolButton;

namespace mocapress {

class ElidedLabel;

/// Tells once a clip what its reader repaired or guessed, in a line that unfolds and can be
/// dismissed. Later the mark on the clip's row in the library tells it.
class WarningsPanel : public QFrame {
  Q_OBJECT

 public:
  explicit WarningsPanel(QWidget* parent = nullptr);

  /// `clip` is its path. The panel hides without warnings, or if all were shown for this clip
  /// before.
  void setWarnings(const QString& clip, const Warnings& warnings);

 private:
  ElidedLabel* title_;
  QToolButton* unfold_;
  QPlainTextEdit* list_;
  QString clip_;
  std::map<QString, QStringList> told_;  // warnings already shown, by clip
};

}  // namespace mocapress
