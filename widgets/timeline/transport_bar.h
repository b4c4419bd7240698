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

/// What the buttons of the transport bar do; shared with menus and shortcuts.
struct TransportActions {
  QAction* first = nullptr;
  QAction* previous = nullptr;
  QAction* play = nullptr;
  QAction* next = nullptr;
  QAction* last = nullptr;
  QAction* loop = nullptr;
  QAction* backwards = nullptr;  // J, K and L of an editing desk
  QAction* halt = nullptr;
  QAction* forwards = nullptr;
  QAction* ten_back = nullptr;
  QAction* ten_on = nullptr;
  QAction* range_from = nullptr;  // the part that is played begins here
  QAction* range_to = nullptr;
  QAction* whole_clip = nullptr;
};

/// Buttons, scrub slider, read-outs of time and frame, and speed, below the 3D view.
class TransportBar : public QWidget {
  Q_OBJECT

 public:
  /// With icons, shortcuts and effect on `playback`.
  static TransportActions makeActions(Playback* playback, QObject* parent);

  TransportBar(Playback* playback, const TransportActions& actions, QWidget* parent = nullptr);

  /// The animations of the file, and which is played. Seen where there are several.
  void setTakes(const QStringList& names, int current);

 signals:
  /// By the user; which one is still to be set.
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
