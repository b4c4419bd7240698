// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Keeps a project for one studio: two that wrote the same file would undo each other's work. The
/// lock is a hidden file beside the project. It names its process, so that a lock left behind by a
/// crash is known as one; it holds in network folders without file locks too.
class ProjectLock {
 public:
  explicit ProjectLock(const QString& project);

  bool held() const { return lock_.isLocked(); }

  /// Another studio holds it. Neither held nor in use: the folder takes no files.
  bool inUse() const { return !held() && lock_.error() == QLockFile::LockFailedError; }

  /// Held now, but the studio that held it last never let it go.
  bool wasLeftBehind() const { return held() && existed_; }

  /// The file beside `project`.
  static QString fileOf(const QString& project);

 private:
  bool existed_;  // before this one asked for it
  QLockFile lock_;
};

/// A project that can be gone on with.
struct FormerProject {
  QString path;
  bool named = false;
  QDateTime written;
  std::optional<int> clips;  // unset: it cannot be read
};

/// A project in its file: which file that is, who else has it, and when it is written. Every change
/// is in the file within two seconds, whether the project has a name or not: a crash loses no more
/// than that, and nobody is asked to save.
class KeptProject : public QObject {
  Q_OBJECT

 public:
  explicit KeptProject(QObject* parent = nullptr);
  ~KeptProject() override;

  const Project& project() const { return project_; }

  /// The project file; empty: nothing is kept.
  const QString& path() const { return path_; }

  /// Empty: the user has not named it.
  QString name() const;

  /// It would have no name where there is something to name.
  bool needsName() const { return name().isEmpty() && !project_.clips.empty(); }

  /// It has clips, and the files of all of them are gone: it can show none.
  bool isOutOfReach() const;

  /// Changes wait that could not be written.
  bool stuck() const { return !trouble_.isEmpty(); }

  /// Begins with an empty project without a name, of those that the studio keeps in `folder`.
  void beginEmpty(const QString& folder);

  /// Goes on with the project that was used last, out of those that the studio keeps in `folder`
  /// or elsewhere. Where it was left without end(), as after a crash, recovered() says so. False:
  /// there was none yet, and an empty one begins.
  bool begin(const QString& folder);

  /// All is written, and this was no crash. Nothing is kept from then on. Like the others below:
  /// false: that was impossible, failed() said why, and everything is as it was.
  bool end();

  /// Goes on with another project; the one before is written.
  bool open(const QString& path);

  /// The same, with a copy that has no name: of a project that another studio has.
  bool openCopy(const QString& path);

  /// Goes on in this file. A named project stays behind as it is; one without a name has one now.
  bool saveAs(const QString& path);

  /// Begins an empty one without a name.
  bool startNew();

  /// Without the one in use, used last first.
  std::vector<FormerProject> formerProjects() const;

  /// `ask` is called before another project takes the place of this one, or the program ends. It
  /// hands over what is still to be kept, and says why the project cannot be left now; empty: it
  /// can. The program ends all the same.
  void setLeaveCheck(std::function<QString()> ask) { ask_ = std::move(ask); }

 signals:
  /// Another project takes its place now, which entered() says once it has: nothing that is under
  /// way for the one before may arrive in the other.
  void leaving();
  void entered();

  /// It is another project, has another name, or is stuck() or no longer.
  void projectChanged();

  /// What is to be kept has changed; saved() follows once all of it is in the file.
  void edited();
  void saved();

  void recovered(int clips);
  void noted(const QString& message);

  /// Another studio has this project.
  void inUse(const QString& path);
  void failed(const QString& message);

  /// From the thread that writes: writing_ is ready.
  void written(QPrivateSignal);

 protected:
  /// The project has been changed.
  void touch();

  Project project_;

 private:
  void writeSoon();
  void write();
  void noteWritten();
  bool flush();
  bool mayLeave();
  void setTrouble(const QString& message);
  bool enter(const QString& path, std::unique_ptr<ProjectLock> lock, Project project);

  QString path_;
  std::function<QString()> ask_;       // see setLeaveCheck()
  std::optional<ProjectShelf> shelf_;  // none: no project is remembered
  std::unique_ptr<ProjectLock> lock_;  // of path_
  QTimer write_later_;
  QElapsedTimer since_write_;     // began
  std::future<QString> writing_;  // what goes wrong with it, empty: nothing; not valid: none runs
  bool changed_ = false;          // since the last write began
  bool unwritten_ = false;        // since the last write that is known to have succeeded
  QString trouble_;               // of the last write; empty: none
};

}  // namespace mocapress
