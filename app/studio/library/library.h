// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSet>
#include <QStringList>
#include <QUndoStack>
#include <deque>
#include <map>
#include <optional>

#include "app/jobs/clip_outline.h"
#include "app/jobs/job_runner.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/library/kept_project.h"
#include "widgets/models/library_model.h"

namespace mocapress {

class LibraryModel;
class Session;

/// Finds the clips below folders in the background, one folder after the other.
class FolderSearch : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void search(const QString& folder);

  /// Nothing more is found.
  void abandon();

 signals:
  /// The motion files below a folder.
  void found(const QStringList& clips);
  void failed(const QString& message);

 private:
  void searchNext();

  QStringList folders_;  // to be searched
  JobRunner finding_{Workers::LongRunning};
};

/// The project as it is worked on: its clips with their settings, what each came to and what was
/// decided. The current clip of a project that is entered is opened.
class Library : public KeptProject {
  Q_OBJECT

 public:
  Library(Session* session, LibraryModel* model, QObject* parent = nullptr);

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

  /// Whether figures are their skin.
  bool showsSkin() const { return project_.shows_skin; }
  void setShowsSkin(bool shows);

  int currentRow() const;

  /// Clips with the settings they were tuned by, for a batch; no rows: all of them.
  std::vector<TunedClip> tuned(const std::vector<int>& rows) const;

  /// What was decided about every clip.
  ClipReviews reviews() const;

 signals:
  void currentChanged();

  /// Clips that were not there before, the first of them in this row.
  void added(int row);

 private:
  void change(const QString& path, const ClipReview& review);
  std::vector<LibraryEntry> entries() const;
  using ClipsByRow = std::map<int, ProjectClip>;

  ClipsByRow takeOut(const QSet<QString>& paths);
  void putBack(const ClipsByRow& clips);
  void noteOpened(const QString& path, const QString& skeleton);
  void noteSettings();
  void noteCharacter();
  void noteOutcome();
  void show(const ProjectClip& clip);
  void showAsRead(const ProjectClip& clip, const OriginalClip& original);
  void readNextOutline();
  void leave();
  void enter();
  ProjectClip* openNow();
  NamedSettings settingsNow() const;

  Session* session_;
  LibraryModel* model_;
  QUndoStack history_;
  JobRunner outlines_{Workers::LongRunning};
  FolderSearch folder_search_;
  std::deque<QString> unread_;  // paths whose outline is not known yet

  // Verdicts that were taken back with the outcome they were about: by path.
  std::map<QString, std::pair<Outcome, Verdict>> withdrawn_;
};

}  // namespace mocapress
