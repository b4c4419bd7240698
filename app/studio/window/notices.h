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
class ViewPictures;

/// Messages above the view: errors, notes and running work.
class Notices : public QObject {
  Q_OBJECT

 public:
  Notices(Session* session, Library* library, MessageBar* bar, QObject* parent);

  /// `choose_skeleton` is offered when an .amc cannot be read.
  void tellOf(ClipFiles* files, QAction* choose_skeleton);
  void tellOf(PresetShelf* presets);
  void tellOf(ViewPictures* pictures);

  void say(const QString& note);

  /// Keeps a note visible when the project's clip opens, which clears other messages.
  void keep(const QString& note);

 private:
  void tellOfSession();
  void tellOfLibrary();
  void showSlowOpening();

  Session* session_;
  Library* library_;
  MessageBar* bar_;
  QTimer slow_opening_;
  QString opening_;  // file being read
  bool is_opening_ = false;
  QString kept_;        // shown again once the project's clip is open
  QString kept_error_;  // likewise
};

}  // namespace mocapress
