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
#include "app/jobs/clip_sources.h"
#include "app/jobs/job_runner.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/library/kept_project.h"
#include "widgets/models/library_model.h"

namespace mocapress {

class LibraryModel;
class Session;
struct BatchStep;
struct OpenRequest;

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
  void setNote(int row, const QString& note);

  /// Sets it for all these rows, in one step. A verdict is about what was reviewed: the files and
  /// settings of the outcome that the row shows, else those of the clip now. A clip whose file is
  /// missing gets none, which failed() says.
  void setVerdict(const std::vector<int>& rows, Verdict verdict);
  void setPreset(const std::vector<int>& rows, const Settings& preset);

  /// Looks whether the files of the clips are still there and what they were. Those that have
  /// changed are read again.
  void checkFiles();

  /// Looks for the missing ones below a folder. They go on from there, in one step.
  void findMissing(const QString& folder);

  /// A batch has exported a clip by these settings: the clip has that outcome now, unless it has
  /// other settings of its own.
  void noteExported(const QString& path, const Settings& settings, const ReadOptions& reading,
                    const BatchStep& step);

  /// What was pinned of a clip.
  std::vector<Pin> pinsOf(const QString& path);
  void setPins(const QString& path, const std::vector<Pin>& pins);

  /// Whether figures are their skin.
  bool showsSkin() const { return project_.shows_skin; }
  void setShowsSkin(bool shows);

  /// The queue of this project's batch.
  void setBatch(const RememberedBatch& batch);

  int currentRow() const;

  /// Clips with the settings they were tuned by, for a batch; no rows: all of them.
  std::vector<TunedClip> tuned(const std::vector<int>& rows) const;

  /// What was decided about every clip.
  ClipReviews reviews() const;

  /// Verdict and note on the clip of that path, as reports have them.
  std::vector<std::string> remarksOn(const QString& path) const;

 signals:
  void currentChanged();

  /// Clips that were not there before, the first of them in this row.
  void added(int row);

 private:
  using Reviews = std::map<QString, ClipReview>;
  using SettingsByPath = std::map<QString, std::optional<NamedSettings>>;

  void apply(const Reviews& reviews);
  void apply(const SettingsByPath& settings);
  void move(const std::map<QString, ClipSource>& to);
  ClipReview reviewNow(const ProjectClip& clip, Verdict verdict) const;
  void noteFiles(const std::vector<ClipSource>& sources, const std::vector<SourceNow>& now);
  void noteOpenFailed(const OpenRequest& request, const QString& message);
  std::vector<LibraryEntry> entries() const;
  using ClipsByRow = std::map<int, ProjectClip>;

  ClipsByRow takeOut(const QSet<QString>& paths);
  void putBack(const ClipsByRow& clips);
  void noteOpened(const QString& path, const QString& skeleton);
  void noteSettings();
  void noteCharacters();
  void noteOutcome();
  void show(const ProjectClip& clip);
  void showRows(const std::vector<int>& rows);
  void showAsRead(const ProjectClip& clip, const OriginalClip& original);
  void readNextOutline();
  void leave();
  void enter();
  ProjectClip* openNow();
  bool isAsNow(const NamedSettings& settings) const;
  NamedSettings settingsNow() const;

  Session* session_;
  LibraryModel* model_;
  QUndoStack history_;
  JobRunner outlines_{Workers::LongRunning};
  FolderSearch folder_search_;
  std::deque<QString> unread_;  // paths whose outline is not known yet
  JobRunner checking_{Workers::LongRunning};
  bool check_again_ = false;  // files may have changed since the check that runs began
  JobRunner finding_{Workers::LongRunning};
};

}  // namespace mocapress
