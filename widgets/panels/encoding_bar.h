// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QProgressBar;
class QToolButton;

namespace mocapress {

class LibraryModel;

/// A button that starts and stops compressing the library's clips in the background, and a bar that
/// shows how many are done.
class EncodingBar : public QWidget {
  Q_OBJECT

 public:
  explicit EncodingBar(const LibraryModel* model, QWidget* parent = nullptr);

  /// Shows whether clips are being compressed. Emits nothing.
  void setActive(bool active);

  QToolButton* button() const { return button_; }
  QProgressBar* progress() const { return progress_; }

 signals:
  void activeChosen(bool active);

 private:
  void count();

  const LibraryModel* model_;
  QToolButton* button_;
  QProgressBar* progress_;
  QTimer count_later_;  // delays counting: thousands of clips may change at once
};

}  // namespace mocapress
