// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <QTimer>
#include <QUndoStack>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <optional>

#include "app/jobs/clip_outline.h"
#include "app/jobs/job_runner.h"
#include "app/studio/batch/batch_session.h"
#include "app/studio/library/folder_search.h"
#include "app/studio/library/project.h"
#include "app/studio/library/project_lock.h"
#include "app/studio/library/project_shelf.h"

namespace mocapress {

class LibraryModel;
class Session;

/// A project that can be gone on with.
struct FormerProject {
  QString path;
  bool named = false;
  QDateTime written;
  std::optional<int> clips;  // unset: it cannot be read
};

/// The project: its clips with their settings, what each came to and what was decided. Every change
/// is in the project's own file within two seconds, whether the project has a name or not: a crash
/// loses no more than that, and nobody is asked to save.
class Library : public QObject {
  Q_OBJECT

 public:
  Library(Session* session, LibraryModel* model, QObject* parent = nullptr);
  ~Library() override;

  const Project& project() const { return project_; }

  /// The project file; empty: nothing is kept.
  const QString& path() const { return path_; }

  /// Empty: the user has not named it.
  QString name() const;

  /// It would have no name where there is something to name.
  bool needsName() const { return name().isEmpty() && !project_.clips.empty(); }

  /// Changes wait that could not be written.
  bool stuck() const { return !trouble_.isEmpty(); }

  /// Begins with an empty project without a name, of those that the studio keeps in `folder`.
  void beginEmpty(const QString& folder);

  /// Goes on with the project that was used last, out of those that the studio keeps in `folder`
  /// or elsewhere. Its current clip is opened. Where it was left without end(), as after a crash,
  /// recovered() says so. False: there was none yet, and an empty one begins.
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

  /// What was done to the list and said about its clips; what was done to a clip is in the history
  /// of its document.
  QUndoStack* history() { return &history_; }

  /// Those that are not there yet. Adding, removing, verdicts and notes are steps of history().
  void add(const QStringList& paths);

  /// All clips below it, found in the background.
  void addFolder(const QString& path);
  void remove(const QList<int>& rows);
  void openClip(int row);
  void setVerdict(int row, Verdict verdict);
  void setNote(int row, const QString& note);

  /// What was pinned of a clip.
  std::vector<Pin> pinsOf(const QString& path);
  void setPins(const QString& path, const std::vector<Pin>& pins);

  int currentRow() const;

  /// Clips with the settings they were tuned by, for a batch; no rows: all of them.
  std::vector<TunedClip> tuned(const std::vector<int>& rows) const;

  /// What was decided about every clip.
  ClipReviews reviews() const;

 signals:
  void currentChanged();

  /// Clips that were not there before, the first of them in this row.
  void added(int row);

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

 private:
  void change(const QString& path, const ClipReview& review);
  std::vector<LibraryEntry> entries() const;
  using ClipsByRow = std::map<int, ProjectClip>;

  ClipsByRow takeOut(const QSet<QString>& paths);
  void putBack(const ClipsByRow& clips);
  void noteOpened(const QString& path, const QString& skeleton);
  void noteSettings();
  void noteOutcome();
  void show(const ProjectClip& clip);
  void showAsRead(const ProjectClip& clip, const OriginalClip& original);
  void readNextOutline();
  void touch();
  void writeSoon();
  void write();
  void noteWritten();
  bool flush();
  void setTrouble(const QString& message);
  bool enter(const QString& path, std::unique_ptr<ProjectLock> lock, Project project);
  void setProject(Project project);
  ProjectClip* openNow();
  NamedSettings settingsNow() const;

  Session* session_;
  LibraryModel* model_;
  Project project_;
  QUndoStack history_;
  QString path_;
  std::optional<ProjectShelf> shelf_;  // none: no project is remembered
  std::unique_ptr<ProjectLock> lock_;  // of path_
  QTimer write_later_;
  QElapsedTimer since_write_;     // began
  std::future<QString> writing_;  // what goes wrong with it, empty: nothing; not valid: none runs
  bool changed_ = false;          // since the last write began
  bool unwritten_ = false;        // since the last write that is known to have succeeded
  QString trouble_;               // of the last write; empty: none
  JobRunner outlines_{Workers::LongRunning};
  FolderSearch folder_search_;
  std::deque<QString> unread_;  // paths whose outline is not known yet

  // Verdicts that were taken back with the outcome they were about: by path.
  std::map<QString, std::pair<Outcome, Verdict>> withdrawn_;
};

}  // namespace mocapress
