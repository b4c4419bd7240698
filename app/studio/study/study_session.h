// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/jobs/job_runner.h"
#include "app/jobs/study_runner.h"
#include "widgets/models/library_model.h"
#include "widgets/models/study_settings.h"

namespace mocapress {

/// A study: its settings, run by jobs, and its rows. Uses no widgets.
class StudySession : public QObject {
  Q_OBJECT

 public:
  enum class State { Idle, Running, Drawing, Complete, Cancelled, Failed, Opened };

  /// `cache` is the folder for rows unless the user chooses another.
  explicit StudySession(const QString& cache, QObject* parent = nullptr);

  const StudySettings& settings() const { return settings_; }
  void setSettings(const StudySettings& settings);

  /// Adds files, and all clips below folders.
  void addClips(const QStringList& paths);
  void removeClips(const QStringList& paths);

  /// Sets the library's reviews, which appear in tables and reports.
  void setReviews(const ClipReviews& reviews) { reviews_ = reviews; }

  /// Sets the folder for rows, and for tables and report once all rows are there. Shows the rows
  /// that the folder already has. Empty: the cache.
  void setFolder(const QString& folder);
  const QString& folder() const { return folder_; }

  /// The number of compressions in the plan.
  int jobs() const;

  /// Measures the missing rows. Does nothing if jobs() is 0.
  void run();

  /// Keeps finished rows; the next run continues from there.
  void cancel();

  State state() const { return state_; }
  bool running() const { return state_ == State::Running || state_ == State::Drawing; }
  const StudyCounts& counts() const { return counts_; }
  double elapsedSeconds() const { return static_cast<double>(clock_.elapsed()) / 1000; }
  const QString& failure() const { return failure_; }

  /// Rows, in the order of the plan once a run has ended.
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// The weighting of the rows' eps_x.
  Weighting weighting() const { return plan_.settings.weighting; }

  /// Paths of the clips that have all their rows.
  std::set<std::string> completeClips() const;

  bool exporting() const { return exporting_.busy(); }
  void exportRows(const QString& path);
  void exportReport(const QString& path);  // takes seconds, since its pictures are compressed again
  void exportFile(const QString& path, const QByteArray& content);
  void cancelExport() { exporting_.abandon(); }

 signals:
  void settingsChanged();
  void folderChanged();

  /// The state or the counts have changed.
  void progressed();

  void rowsCleared();
  void rowsAdded(const std::vector<StudyRow>& rows);

  /// Some clips could not be added.
  void addFailed(const QString& message);

  /// A message for the user that needs no answer.
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
  std::optional<ClipReview> reviewOf(const QString& path) const;  // unset: the library has none
  std::vector<StudyRow> reviewedRows() const;
  template <typename Make>
  void exportMade(const QString& path, Make make);

  QString cache_;
  QString folder_;
  StudySettings settings_;
  ClipReviews reviews_;
  StudyPlan plan_;                       // plan of rows_
  std::map<std::string, int> expected_;  // number of rows for each clip
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
