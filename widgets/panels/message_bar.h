// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>

class QAction;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace mocapress {

/// Shows one message in the window without blocking it. Errors stay until closed or replaced; notes
/// disappear by themselves.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showNote(const QString& text);

  /// Shows a running task until replaced or hidden.
  void showWork(const QString& text);

  /// Shows an error, with a button for `remedy` if that is given. The bar does not own the action.
  void showError(const QString& text, QAction* remedy = nullptr);

  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showText(const QString& text, bool error, QAction* remedy);
  void applyColours();

  bool error_ = false;
  QLabel* text_;
  QProgressBar* work_;
  QToolButton* remedy_;
  QTimer leave_;
};

}  // namespace mocapress
