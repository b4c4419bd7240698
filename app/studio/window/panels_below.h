// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace mocapress {

/// Folds the docks below the timeline to their tabs where the 3D view would become too low
/// otherwise. A click on a tab unfolds the docks; a click on the tab in front folds them.
class PanelsBelow : public QObject {
  Q_OBJECT

 public:
  /// Height of a folded dock.
  static constexpr int kFolded = 1;

  /// `view` is the 3D view, within the window's central widget.
  PanelsBelow(QMainWindow* window, const QWidget* view);

  bool unfolded() const { return height() > kFolded; }
  void unfold();
  void toggle();

  /// Gives the docks the height that the user chose in a window of this height. In a window of
  /// another height they get at most what the 3D view leaves.
  void fit();

  /// Keeps the height that the user chose, from run to run.
  void restore();
  void remember() const;
  void reset();

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void watch(QObject* child);
  QList<QDockWidget*> docks() const;
  QList<QDockWidget*> inFront() const;
  int height() const;
  void choose(int height);
  void resize(int height);
  void showTitles(bool shown);
  void click(const QTabBar& bar, int tab, bool was_in_front);

  QMainWindow* window_;
  const QWidget* view_;
  int chosen_;            // height, initially a usual one, then the user's choice
  int chosen_at_ = 0;     // height of the window at that choice
  int unfolded_height_;   // last chosen height of at least kLeastHeight
  int pressed_tab_ = -1;  // tab that the mouse is pressed on; -1: none
  bool pressed_in_front_ = false;
};

}  // namespace mocapress
