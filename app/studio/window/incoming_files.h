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

/// Opens files and folders from the command line or dropped on the window: clips, skeletons,
/// projects.
class IncomingFiles : public QObject {
  Q_OBJECT

 public:
  /// Accepts drops on `window`.
  IncomingFiles(Session* session, Library* library, ClipFiles* files, ProjectFiles* projects,
                Notices* notices, QWidget* window);

  /// Opens one file with its skeleton. Several files and folders are added to the library, and the
  /// first is opened if no clip is open. A project among them is opened first.
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
  bool opens_added_ = false;  // opens the first clip added next
};

}  // namespace mocapress
