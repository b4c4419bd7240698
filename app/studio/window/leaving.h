// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace mocapress {

class ClipFiles;
class Library;
class ProjectFiles;
class Session;

/// Whether the window may be closed: not before a compressed clip that would be lost is saved or
/// given up, nor before the project is in its file.
class Leaving : public QObject {
  Q_OBJECT

 public:
  Leaving(Session* session, ClipFiles* files, Library* library, ProjectFiles* projects,
          QWidget* window);

  /// Asked when the window is to close. False: the user is asked, and closes it by the answer.
  bool mayClose();

 private:
  Session* session_;
  ClipFiles* files_;
  Library* library_;
  ProjectFiles* projects_;
  QWidget* window_;
  bool may_lose_clip_ = false;
  bool may_lose_project_ = false;  // what cannot be written of it
};

}  // namespace mocapress
