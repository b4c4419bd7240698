// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QProgressBar;
class QToolButton;

namespace mocapress {

class LibraryModel;

/// Shows the number of reviewed clips, and a button that goes to the next clip without a valid
/// verdict.
class ReviewBar : public QWidget {
  Q_OBJECT

 public:
  explicit ReviewBar(const LibraryModel* model, QWidget* parent = nullptr);

  QToolButton* next() const { return next_; }
  QProgressBar* progress() const { return progress_; }

 signals:
  void nextRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void count();
  void showText();

  const LibraryModel* model_;
  QToolButton* next_;
  QProgressBar* progress_;
  QString reviewed_;
  QString with_rejected_;
  QTimer count_later_;  // delays counting: thousands of clips may change at once
};

}  // namespace mocapress
