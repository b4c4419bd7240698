// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_session.h"

#include <QFileInfo>
#include <algorithm>
#include <optional>

#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/formats/clip_files.h"
#include "core/study/row.h"
#include "core/study/study_folder.h"
#include "widgets/models/report_texts.h"
#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// The parts of an opened study's plan that pictures need.
StudyPlan planOfRows(const std::vector<StudyRow>& rows) {
  StudyPlan plan;
  if (rows.empty()) return plan;
  plan.settings.weighting = rows.back().settings.weighting;
  plan.settings.seed = rows.back().settings.seed;
  return plan;
}

/// Reads only rows of the newest weighting: the folder may hold others, which do not compare.
std::vector<StudyRow> readStudy(const fs::path& folder) {
  if (!is_there(folder / kRowsSoFar)) return {};
  std::vector<StudyRow> rows = read_rows(folder / kRowsSoFar);
  if (rows.empty()) return rows;
  const Weighting newest = rows.back().settings.weighting;
  std::erase_if(rows, [&](const StudyRow& row) { return row.settings.weighting != newest; });
  return rows;
}

}  // namespace

StudySession::StudySession(const QString& cache, QObject* parent)
    : QObject(parent), cache_(cache), settings_(usualStudySettings()) {
  clock_.start();
  connect(&runner_, &StudyRunner::advanced, this, &StudySession::advance);
  connect(&runner_, &StudyRunner::failed, this,
          [this](const QString& message) { setState(State::Failed, message); });
  connect(&runner_, &StudyRunner::ended, this, [this](const StudyOutcome& outcome) {
    rows_ = outcome.rows;
    for (const Warning& warning : outcome.warnings)
      emit noted(translatedSentence(QString::fromStdString(warning.text())));
    setState(outcome.complete ? State::Complete : State::Cancelled);
  });
  connect(&exporting_, &JobRunner::busyChanged, this, &StudySession::exportingChanged);
}

void StudySession::setSettings(const StudySettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  emit settingsChanged();
}

void StudySession::addClips(const QStringList& paths) {
  to_find_ += paths;
  findClips();
}

void StudySession::findClips() {
  finding_.start(
      [paths = to_find_](const Job&) {
        std::vector<fs::path> inputs;
        for (const QString& path : paths)
          inputs.emplace_back(QFileInfo(path).absoluteFilePath().toStdU16String());
        QStringList clips;
        for (const fs::path& clip : find_clips(inputs))
          clips << QString::fromStdU16String(clip.u16string());
        return clips;
      },
      [this](const QStringList& clips) {
        to_find_.clear();
        StudySettings settings = settings_;
        for (const QString& clip : clips)
          if (!settings.clips.contains(clip)) settings.clips << clip;
        setSettings(settings);
      },
      [this](const QString& message) {
        to_find_.clear();
        emit addFailed(message);
      });
}

void StudySession::removeClips(const QStringList& paths) {
  StudySettings settings = settings_;
  settings.clips.removeIf([&](const QString& clip) { return paths.contains(clip); });
  setSettings(settings);
}

void StudySession::setFolder(const QString& folder) {
  folder_ = folder;
  emit folderChanged();
  if (folder.isEmpty()) return;
  opening_.start([path = fs::path(folder.toStdU16String())](const Job&) { return readStudy(path); },
                 [this](const std::vector<StudyRow>& rows) { showOpened(rows); },
                 [this](const QString& message) { setState(State::Failed, message); });
}

void StudySession::showOpened(std::vector<StudyRow> rows) {
  if (rows.empty() || running()) return;
  plan_ = planOfRows(rows);
  clear();
  counts_ = {static_cast<int>(rows.size()), static_cast<int>(rows.size()), 0};
  for (const StudyRow& row : rows) ++expected_[row.clip];
  rows_ = std::move(rows);
  emit rowsAdded(rows_);
  setState(State::Opened);
}

int StudySession::jobs() const {
  return static_cast<int>(jobs_of(planOf(settings_)).size());
}

void StudySession::run() {
  const int jobs = this->jobs();
  if (jobs == 0) return;
  opening_.abandon();
  plan_ = planOf(settings_);
  for (StudyClip& clip : plan_.clips)
    clip.review = reviewOf(QString::fromStdU16String(clip.path.u16string())).value_or(ClipReview());
  clear();
  for (const StudyJob& job : jobs_of(plan_)) ++expected_[plan_.clips[job.clip].path.string()];
  counts_ = {jobs, 0, 0};
  clock_.restart();
  setState(State::Running);
  runner_.start({plan_, folder_.isEmpty() ? cache_ : folder_, !folder_.isEmpty()});
}

void StudySession::cancel() {
  runner_.cancel();
}

void StudySession::clear() {
  rows_.clear();
  expected_.clear();
  counts_ = {};
  emit rowsCleared();
}

void StudySession::advance(const StudyCounts& counts, const std::vector<StudyRow>& rows) {
  counts_ = counts;
  rows_.insert(rows_.end(), rows.begin(), rows.end());
  if (!rows.empty()) emit rowsAdded(rows);
  setState(counts.done == counts.jobs && !folder_.isEmpty() ? State::Drawing : State::Running);
}

void StudySession::setState(State state, const QString& failure) {
  state_ = state;
  failure_ = failure;
  emit progressed();
}

std::set<std::string> StudySession::completeClips() const {
  std::map<std::string, int> there;
  for (const StudyRow& row : rows_) ++there[row.clip];
  std::set<std::string> complete;
  for (const auto& [clip, rows] : there)
    if (const auto found = expected_.find(clip); found != expected_.end() && found->second == rows)
      complete.insert(clip);
  return complete;
}

/// Writes the text that `make(job)` returns; it returns none if the job was stopped.
template <typename Make>
void StudySession::exportMade(const QString& path, Make make) {
  exporting_.start(
      [path, make = std::move(make)](const Job& job) {
        const std::optional<std::string> text = make(job);
        if (text) write_text(path.toStdU16String(), *text);
        return text.has_value();
      },
      [this, path](bool written) {
        if (written) emit exported(path);
      },
      [this](const QString& message) { emit exportFailed(message); });
}

namespace {

/// The review without a verdict on other bytes; the note then tells of it. Settings are not
/// compared: a study has many, and the review concerns its clips.
ClipReview present(const LibraryReview& said) {
  ClipReview review = said.review;
  if (review.verdict == Verdict::None ||
      (!said.missing && review.source_hash == said.source && !said.source.empty()))
    return review;
  const char* why = said.missing                 ? "file missing"
                    : review.source_hash.empty() ? "not known what was reviewed"
                                                 : "file changed";
  review.note = "stale verdict (" + std::string(why) + ", was " +
                std::string(name(review.verdict)) + ")" +
                (review.note.empty() ? "" : ": " + review.note);
  review.verdict = Verdict::None;
  return review;
}

}  // namespace

/// The review of a clip. For a file with several takes, it has the verdict that all takes share,
/// and says which take each note is on.
std::optional<ClipReview> StudySession::reviewOf(const QString& path) const {
  if (const auto found = reviews_.find(path); found != reviews_.end()) return present(*found);
  std::map<QString, ClipReview> takes;
  const QString begin = path + QLatin1Char('\n');  // as in clipKey()
  for (auto it = reviews_.begin(); it != reviews_.end(); ++it)
    if (it.key().startsWith(begin)) takes.emplace(it.key().mid(begin.size()), present(*it));
  if (takes.empty()) return {};
  ClipReview all = takes.begin()->second;
  all.note.clear();
  for (const auto& [take, review] : takes) {
    if (review.verdict != all.verdict) all.verdict = Verdict::None;
    std::string said = review.verdict == Verdict::None ? "" : std::string(name(review.verdict));
    if (!review.note.empty()) said += (said.empty() ? "" : ", ") + review.note;
    if (!said.empty())
      all.note += (all.note.empty() ? "" : "; ") + take.toStdString() + ": " + said;
  }
  return all;
}

/// The rows with the library's current reviews.
std::vector<StudyRow> StudySession::reviewedRows() const {
  std::vector<StudyRow> rows = rows_;
  std::map<std::string, std::optional<ClipReview>> known;  // a clip has many rows
  for (StudyRow& row : rows) {
    const auto [clip, is_new] = known.try_emplace(row.clip);
    if (is_new) clip->second = reviewOf(QString::fromStdString(row.clip));
    if (clip->second) row.review = *clip->second;
  }
  return rows;
}

void StudySession::exportRows(const QString& path) {
  exportMade(path, [rows = reviewedRows()](const Job&) { return std::optional(rows_csv(rows)); });
}

void StudySession::exportReport(const QString& path) {
  exportMade(path,
             [rows = reviewedRows(), plan = plan_, language = reportLanguage()](const Job& job) {
               return study_report(
                   plan, Results(rows), [&](const EncodeProgress&) { return !job.stopRequested(); },
                   nullptr, language);
             });
}

void StudySession::exportFile(const QString& path, const QByteArray& content) {
  if (content.isEmpty()) {
    emit exportFailed(tr("The picture could not be made."));
    return;
  }
  exportMade(path, [content](const Job&) { return std::optional(content.toStdString()); });
}

}  // namespace mocapress
