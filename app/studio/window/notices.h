// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

class QAction;

namespace mocapress {

class ClipFiles;
class Library;
class MessageBar;
class PresetShelf;
class Session;

/// What the studio says above the view: what goes wrong, what was done, what takes long.
class Notices : public QObject {
  Q_OBJECT

 public:
  Notices(Session* session, Library* library, MessageBar* bar, QObject* parent);

  /// `choose_skeleton`: the remedy for an .amc that was not read.
  void tellOf(ClipFiles* files, QAction* choose_skeleton);
  void tellOf(PresetShelf* presets);

  void say(const QString& note);

  /// Opening the clip of a project takes older messages away, but not this one.
  void keep(const QString& note);

 private:
  void tellOfSession();
  void tellOfLibrary();
  void showSlowOpening();

  Session* session_;
  Library* library_;
  MessageBar* bar_;
  QTimer slow_opening_;
  QString opening_;  // the file that is being read
  bool is_opening_ = false;
  QString kept_;        // said again once the clip of the project is open
  QString kept_error_;  // likewise
};

}  // namespace mocapress
