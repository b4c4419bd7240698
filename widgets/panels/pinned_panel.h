// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPushButton;
class QTreeView;

namespace mocapress {

class PinnedModel;

/// Lists the pinned results with their figures, and the actions on them.
class PinnedPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PinnedPanel(PinnedModel* model, QWidget* parent = nullptr);

  /// Tells whether there is a result to pin and room for it.
  void setCanPin(bool can);

  QTreeView* view() const { return view_; }
  QPushButton* pinButton() const { return pin_; }
  QPushButton* makeCurrentButton() const { return make_current_; }

  QSize sizeHint() const override { return {310, 200}; }

 signals:
  void pinRequested();
  void unpinRequested(int row);
  void makeCurrentRequested(int row);

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void fitNames();
  int current() const;
  void showChosen();

  PinnedModel* model_;
  QTreeView* view_;
  QPushButton* pin_;
  QPushButton* make_current_;
  QPushButton* unpin_;
};

}  // namespace mocapress
