// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace mocapress {

class ClipFiles;
class Library;
class Notices;
class ProjectFiles;
class Session;

/// Files and folders that come from outside, named on the command line or dropped on the window:
/// clips, their skeletons, projects.
class IncomingFiles : public QObject {
  Q_OBJECT

 public:
  /// Takes what is dropped on `window`.
  IncomingFiles(Session* session, Library* library, ClipFiles* files, ProjectFiles* projects,
                Notices* notices, QWidget* window);

  /// One file is opened, with its skeleton; several and folders come into the library, and the
  /// first of them is opened if nothing is open yet. With a project among them they come into that.
  void open(const QStringList& paths, const QString& skeleton = {});

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void openClips(const QStringList& paths, const QString& skeleton, bool opens_first);

  Session* session_;
  Library* library_;
  ClipFiles* files_;
  ProjectFiles* projects_;
  Notices* notices_;
  bool opens_added_ = false;  // what comes into the library next
};

}  // namespace mocapress
