// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/jobs/job_runner.h"
#include "app/jobs/study_runner.h"
#include "widgets/models/library_model.h"
#include "widgets/models/study_settings.h"

namespace mocapress {

/// What the user wants of a study, done by jobs, and its rows. No widgets.
class StudySession : public QObject {
  Q_OBJECT

 public:
  enum class State { Idle, Running, Drawing, Complete, Cancelled, Failed, Opened };

  /// `cache`: the folder where rows are kept unless the user chooses another.
  explicit StudySession(const QString& cache, QObject* parent = nullptr);

  const StudySettings& settings() const { return settings_; }
  void setSettings(const StudySettings& settings);

  /// Files, and folders for all clips below them.
  void addClips(const QStringList& paths);
  void removeClips(const QStringList& paths);

  /// What a library says about clips, which goes into tables and reports.
  void setReviews(const ClipReviews& reviews) { reviews_ = reviews; }

  /// Where rows are kept, with tables and report once all are there; shows the rows it holds.
  /// Empty: the cache.
  void setFolder(const QString& folder);
  const QString& folder() const { return folder_; }

  /// Compressions that are asked for.
  int jobs() const;

  /// Measures what is not measured yet. Nothing while there are no jobs().
  void run();

  /// What is done stays, and the next run goes on from there.
  void cancel();

  State state() const { return state_; }
  bool running() const { return state_ == State::Running || state_ == State::Drawing; }
  const StudyCounts& counts() const { return counts_; }
  double elapsedSeconds() const { return static_cast<double>(clock_.elapsed()) / 1000; }
  const QString& failure() const { return failure_; }

  /// In the order of the plan once a run has ended.
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// Of the eps_x of the rows.
  Weighting weighting() const { return plan_.settings.weighting; }

  /// Paths of the clips of which all rows are there.
  std::set<std::string> completeClips() const;

  bool exporting() const { return exporting_.busy(); }
  void exportRows(const QString& path);
  void exportReport(const QString& path);  // takes seconds: its pictures are compressed anew
  void exportFile(const QString& path, const QByteArray& content);
  void cancelExport() { exporting_.abandon(); }

 signals:
  void settingsChanged();
  void folderChanged();

  /// State or counts.
  void progressed();

  void rowsCleared();
  void rowsAdded(const std::vector<StudyRow>& rows);

  /// Clips that could not be added.
  void addFailed(const QString& message);

  /// Worth telling, and no more than that.
  void noted(const QString& message);

  void exportingChanged(bool exporting);
  void exported(const QString& path);
  void exportFailed(const QString& message);

 private:
  void setState(State state, const QString& failure = {});
  void clear();
  void advance(const StudyCounts& counts, const std::vector<StudyRow>& rows);
  void showOpened(std::vector<StudyRow> rows);
  void findClips();
  ClipReview reviewOf(const QString& path) const;
  std::vector<StudyRow> reviewedRows() const;
  template <typename Make>
  void exportMade(const QString& path, Make make);

  QString cache_;
  QString folder_;
  StudySettings settings_;
  ClipReviews reviews_;
  StudyPlan plan_;                       // of rows_
  std::map<std::string, int> expected_;  // rows a clip
  std::vector<StudyRow> rows_;
  State state_ = State::Idle;
  StudyCounts counts_;
  QElapsedTimer clock_;
  QString failure_;
  QStringList to_find_;
  StudyRunner runner_;
  JobRunner opening_;
  JobRunner finding_{Workers::LongRunning};
  JobRunner exporting_;
};

}  // namespace mocapress
