// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QSlider;

namespace mocapress {

class Playback;

/// Actions of the transport bar's buttons, shared with menus and shortcuts.
struct TransportActions {
  QAction* first = nullptr;
  QAction* previous = nullptr;
  QAction* play = nullptr;
  QAction* next = nullptr;
  QAction* last = nullptr;
  QAction* loop = nullptr;
  QAction* backwards = nullptr;  // J, K and L, as in video editors
  QAction* halt = nullptr;
  QAction* forwards = nullptr;
  QAction* ten_back = nullptr;
  QAction* ten_on = nullptr;
  QAction* range_from = nullptr;  // sets the start of the played range
  QAction* range_to = nullptr;
  QAction* whole_clip = nullptr;
};

/// The bar below the 3D view: buttons, time slider, time and frame display, and speed.
class TransportBar : public QWidget {
  Q_OBJECT

 public:
  /// Makes actions with icons and shortcuts that control `playback`.
  static TransportActions makeActions(Playback* playback, QObject* parent);

  TransportBar(Playback* playback, const TransportActions& actions, QWidget* parent = nullptr);

  /// Sets the animations of the file, and the one that is played. The choice is hidden if there is
  /// only one animation.
  void setTakes(const QStringList& names, int current);

 signals:
  /// The user chose a take; the owner answers by setTakes().
  void takeChosen(int take);

 private:
  void showClip();
  void showFrame(int frame);

  Playback* playback_;
  QComboBox* takes_;
  QSlider* scrub_;
  QLabel* time_;
  QLabel* frame_;
  QComboBox* speed_;
};

}  // namespace mocapress
