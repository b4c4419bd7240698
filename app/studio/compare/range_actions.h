// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace mocapress {

class Playback;
class Session;

/// Actions on the chosen range, which is the one that is played: more care, contacts on or off; and
/// on the clip as a loop. Each change is a step of the clip's history.
class RangeActions : public QObject {
  Q_OBJECT

 public:
  RangeActions(Session* session, Playback* playback, QObject* parent = nullptr);
  ~RangeActions() override;

  /// The actions that open the three menus, to be put into any menu.
  QList<QAction*> actions() const;

  QMenu* care() const { return care_; }
  QMenu* contacts() const { return contacts_; }
  QMenu* loop() const { return loop_; }

 private:
  void fillCare();
  void fillContacts();
  void fillLoop();
  void update();

  Session* session_;
  Playback* playback_;
  QMenu* care_;
  QMenu* contacts_;
  QMenu* loop_;
};

}  // namespace mocapress
