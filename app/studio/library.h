// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <QTimer>
#include <deque>
#include <map>
#include <memory>

#include "app/jobs/clip_outline.h"
#include "app/jobs/job_runner.h"
#include "app/studio/batch_session.h"
#include "app/studio/folder_search.h"
#include "app/studio/project.h"
#include "app/studio/review_change.h"

namespace mocapress {

class LibraryModel;
class Session;

/// The project: its clips with their settings, what each came to and what was decided. Every change
/// is in its file a moment later, so that a crash loses nothing and nobody is asked to save.
class Library : public QObject {
  Q_OBJECT

 public:
  Library(Session* session, LibraryModel* model, QObject* parent = nullptr);
  ~Library() override;

  const Project& project() const { return project_; }

  /// The project file; empty: nothing is kept.
  const QString& path() const { return path_; }

  /// Goes on with a project of an earlier run, kept in this file from now on. Its current clip is
  /// opened. Where it was left without end(), as after a crash, recovered() says so. False: there
  /// was nothing to go on with.
  bool begin(const QString& path);

  /// All is written, and this was no crash.
  void end();

  /// Those that are not there yet. Adding and removing are steps of the open clip's history.
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

  /// Goes on with a project that has a name; the one before is written.
  void openProject(const QString& path);

  /// Keeps the project in another file from now on.
  void saveAs(const QString& path);

  /// An empty one in the same file as begin() was called with.
  void startNew();

  int currentRow() const;

  /// Clips with the settings they were tuned by, for a batch; no rows: all of them.
  std::vector<TunedClip> tuned(const std::vector<int>& rows) const;

 signals:
  void currentChanged();

  /// Clips that were not there before, the first of them in this row.
  void added(int row);
  void recovered(int clips);
  void failed(const QString& message);

 private:
  void change(const QString& path, const Review& review);
  std::vector<LibraryEntry> entries() const;
  using ClipsByRow = std::map<int, ProjectClip>;

  ClipsByRow takeOut(const QSet<QString>& paths);
  void putBack(const ClipsByRow& clips);
  void noteOpened(const QString& path, const QString& skeleton);
  void noteSettings();
  void noteOutcome();
  void show(const ProjectClip& clip);
  void readNextOutline();
  void touch();
  void write();
  void writeAll();
  bool load(const QString& path);
  ProjectClip* openNow();

  Session* session_;
  LibraryModel* model_;
  Project project_;
  QString path_;
  QString home_;  // where a project without a name is kept
  std::unique_ptr<QLockFile> lock_;
  QTimer write_later_;
  JobRunner writing_;
  JobRunner outlines_;
  FolderSearch folder_search_;
  std::deque<QString> unread_;  // paths whose outline is not known yet
  bool changed_ = false;        // since the last write

  // Verdicts that were taken back with the outcome they were about: by path.
  std::map<QString, std::pair<Outcome, Verdict>> withdrawn_;
};

}  // namespace mocapress
