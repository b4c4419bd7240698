// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QElapsedTimer>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/library/project.h"
#include "app/studio/library/project_shelf.h"

namespace mocapress {

/// Reserves a project for one studio, since two would overwrite each other's work. The lock is a
/// hidden file beside the project with the process id of the studio, so that a lock left by a crash
/// is recognised. It also works in network folders without file locks. Someone on another computer
/// can take such a lock over, so each write first checks whether the lock is still this studio's.
class ProjectLock {
 public:
  explicit ProjectLock(const QString& project);

  /// Releases the lock, unless another studio has taken it over.
  ~ProjectLock();

  bool held() const { return lock_->isLocked(); }

  /// True if this lock was held and its file is now another studio's, or gone. False if that cannot
  /// be told.
  bool lost() const;

  /// True if another studio holds the lock. If the lock is neither held nor in use, the folder
  /// cannot be written.
  bool inUse() const { return !held() && lock_->error() == QLockFile::LockFailedError; }

  /// True if this lock is held, and an earlier studio ended without releasing its own.
  bool wasLeftBehind() const { return held() && existed_; }

  /// The path of the lock for `project`.
  static QString fileOf(const QString& project);

 private:
  QByteArray content() const;

  QString file_;
  bool existed_;  // a lock file existed before
  std::unique_ptr<QLockFile> lock_;
  QByteArray own_;  // content of the file since this lock is held: process, program, computer
};

/// A project that can be opened again.
struct FormerProject {
  QString path;
  bool named = false;
  QDateTime written;
  std::optional<int> clips;  // unset: its file cannot be read
};

/// A project and its file: its path, its lock and its writing. Every change is in the file within
/// two seconds, also in a project without a name: a crash loses no more than that, and nobody is
/// asked to save.
class KeptProject : public QObject {
  Q_OBJECT

 public:
  explicit KeptProject(QObject* parent = nullptr);
  ~KeptProject() override;

  const Project& project() const { return project_; }

  /// The project file; empty: nothing is saved.
  const QString& path() const { return path_; }

  /// Empty until the user names the project.
  QString name() const;

  /// True for a project without a name that has clips.
  bool needsName() const { return name().isEmpty() && !project_.clips.empty(); }

  /// True if the project has clips and all of their files are gone.
  bool isOutOfReach() const;

  /// True while changes could not be written.
  bool stuck() const { return !trouble_.isEmpty(); }

  /// Starts an empty project without a name, in a file in `folder`.
  void beginEmpty(const QString& folder);

  /// Opens the project that was used last, from `folder` or elsewhere. If it was left without
  /// end(), as after a crash, emits recovered(). False: there was none, and an empty one was
  /// started.
  bool begin(const QString& folder);

  /// Writes everything and marks a regular end; nothing is saved afterwards. False, here and for
  /// the functions below: the call failed, failed() gave the reason, and nothing has changed.
  bool end();

  /// Opens another project after writing this one.
  bool open(const QString& path);

  /// Opens an unnamed copy of a project that another studio has open.
  bool openCopy(const QString& path);

  /// Continues in this file. The old file of a named project stays; an unnamed project now has a
  /// name.
  bool saveAs(const QString& path);

  /// Starts an empty project without a name.
  bool startNew();

  /// All projects except the open one, last used first.
  std::vector<FormerProject> formerProjects() const;

  /// Sets a function that is called before another project replaces this one or the program ends.
  /// It hands over what is still to be saved, and returns the reason why the project cannot be left
  /// now; empty: it can. The program ends in any case.
  void setLeaveCheck(std::function<QString()> ask) { ask_ = std::move(ask); }

 signals:
  /// Another project will replace this one, followed by entered(). Jobs of this project must not
  /// deliver into the next.
  void leaving();
  void entered();

  /// The project itself, its name or stuck() has changed.
  void projectChanged();

  /// Something worth saving has changed; saved() follows once it is in the file.
  void edited();
  void saved();

  void recovered(int clips);
  void noted(const QString& message);

  /// Another studio has this project open.
  void inUse(const QString& path);
  void failed(const QString& message);

  /// Emitted by the writing thread: writing_ is ready.
  void written(QPrivateSignal);

 protected:
  /// Notes a change of the project.
  void touch();

  Project project_;

 private:
  void writeSoon();
  void write();
  void noteWritten();
  bool flush();
  void finishWriting();
  bool lostLock() const { return lock_ && lock_->lost(); }
  void dropUnnamed(const QString& path);
  bool mayLeave();
  void setTrouble(const QString& message);
  bool enter(const QString& path, std::unique_ptr<ProjectLock> lock, Project project);

  QString path_;
  std::function<QString()> ask_;       // see setLeaveCheck()
  std::optional<ProjectShelf> shelf_;  // unset: no list of projects is kept
  std::unique_ptr<ProjectLock> lock_;  // lock of path_
  QTimer write_later_;
  QElapsedTimer since_write_;     // since the last write began
  std::future<QString> writing_;  // its error, empty: none; not valid: no write is running
  bool changed_ = false;          // changed since the last write began
  bool unwritten_ = false;        // changed since the last successful write
  QString trouble_;               // error of the last write; empty: none
};

}  // namespace mocapress
