// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QVector3D>

class QWidget;

namespace mocapress {

class Library;
class NoteStrip;
class Playback;
class Session;
class Viewport;
struct FrameNote;

/// The notes on frames of the open clip: shown on the timeline, added, edited and removed. Each
/// change is a step of the library's history.
class FrameNotes : public QObject {
  Q_OBJECT

 public:
  FrameNotes(Session* session, Library* library, Playback* playback, NoteStrip* strip,
             QWidget* window);

  /// Shows notes in the 3D view, too, where a click with Ctrl adds one.
  void showIn(Viewport* viewport);

  /// Asks for a note on the frame that is shown, and the joint that is chosen.
  void addHere();

  /// Asks for a note on the chosen range.
  void addOnRange();

  /// Goes to the next note after the shown frame, and from the last note to the first.
  void showNext();

 private:
  void show();
  void choose(int index);
  void edit(int index);
  void add(FrameNote note);
  void ask(const FrameNote& note, int index);
  void addAt(int joint, const QVector3D& place_cm);

  Session* session_;
  Library* library_;
  Playback* playback_;
  NoteStrip* strip_;
  QWidget* window_;
  Viewport* viewport_ = nullptr;
};

}  // namespace mocapress
