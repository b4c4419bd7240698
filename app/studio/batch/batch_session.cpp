// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_session.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <numeric>
#include <set>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/preset_shelf.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/batch/queue_json.h"
#include "core/batch/slurm_script.h"
#include "core/formats/motion_file.h"
#include "widgets/models/report_texts.h"
#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

constexpr int kRememberDelay = 300;       // ms
constexpr const char* kNoPreset = "own";  // name of settings without a preset

std::filesystem::path pathOf(const QString& text) {
  return text.toStdU16String();
}

/// True if the settings name joints or frames, which other clips may lack.
bool namesJoints(const Settings& preset) {
  return !preset.importance.factors.empty() || preset.contacts || !preset.ranges.empty() ||
         (preset.correction && !preset.correction->effectors.empty());
}

/// Throws Error.
Motion motionOf(const TunedClip& clip) {
  std::optional<std::filesystem::path> skeleton;
  if (!clip.skeleton.isEmpty()) skeleton = pathOf(clip.skeleton);
  return read_motion_of_many(pathOf(clip.path), skeleton, clip.reading).motion;
}

}  // namespace

QueuedClip queuedClip(const TunedClip& clip) {
  QueuedClip queued{
      .source = {clip.path.toStdString(), QFileInfo(clip.path).dir().dirName().toStdString(), {}},
      .skeleton = clip.skeleton.toStdString(),
      .reading = clip.reading};
  if (!clip.settings) return queued;
  queued.own = clip.settings->preset;
  if (queued.own->name.empty()) queued.own->name = kNoPreset;
  if (!namesJoints(*queued.own)) return queued;
  try {
    const std::string name = queued.own->name;
    queued.own = fitting(*clip.settings, motionOf(clip)).preset;
    queued.own->name = name;
  } catch (const Error&) {
    // The batch will report the error.
  }
  return queued;
}

BatchSession::BatchSession(PresetShelf* presets, QObject* parent)
    : QObject(parent), presets_(presets) {
  remember_later_.setSingleShot(true);
  remember_later_.setInterval(kRememberDelay);
  connect(&remember_later_, &QTimer::timeout, this, &BatchSession::keep);
  connect(&queue_, &BatchQueueModel::edited, this, [this] {
    remember_later_.start();
    if (!running()) setState(State::Idle);
  });
  connect(&runner_, &BatchRunner::advanced, this, &BatchSession::advance);
  connect(&runner_, &BatchRunner::bankAdvanced, this, [this](const BankProgress& bank) {
    bank_ = bank;
    emit progressed();
  });
  connect(&runner_, &BatchRunner::ended, this, &BatchSession::end);
  connect(&runner_, &BatchRunner::failed, this, [this](const QString& message) {
    queue_.stopWorking();
    setState(State::Failed, message);
  });
}

void BatchSession::recall(const RememberedBatch& batch) {
  finding_.abandon();
  to_find_.clear();
  fitting_.abandon();
  to_fit_.clear();
  history_.clear();
  settings_ = batch.settings;
  counts_ = {};
  bank_.reset();
  queue_.replace(batch.common, batch.clips);
  queue_.setReviews(reviews_);
  remember_later_.stop();  // the project has this state already
  emit settingsChanged();
  setState(State::Idle);
}

void BatchSession::rememberNow() {
  if (!remember_later_.isActive()) return;
  remember_later_.stop();
  emit keep();
}

void BatchSession::apply(const BatchSettings& settings) {
  const bool anew = settings.folder != settings_.folder || settings.names != settings_.names ||
                    settings.formats != settings_.formats ||
                    settings.character != settings_.character;
  settings_ = settings;
  if (anew) queue_.waitAgain();
  remember_later_.start();
  emit settingsChanged();
  setState(State::Idle);
}

/// Refuses changes to the queue of a running batch and tells the user.
bool BatchSession::refused() {
  if (running()) emit noted(tr("Clips can be added after the batch has ended."));
  return running();
}

void BatchSession::addClips(const QStringList& paths) {
  if (refused()) return;
  to_find_ += paths;
  finding_.start(
      [paths = to_find_](const Job&) {
        std::vector<std::string> inputs;
        for (const QString& path : paths)
          inputs.push_back(QFileInfo(path).absoluteFilePath().toStdString());
        return find_sources(inputs);
      },
      [this](const std::vector<SourceClip>& sources) {
        to_find_.clear();
        std::vector<QueuedClip> clips;
        for (const SourceClip& source : sources) {
          if (source.problem.empty())
            clips.push_back({.source = source});
          else
            emit noted(QString::fromStdString(source.problem));
        }
        if (!refused()) add(clips);
      },
      [this](const QString& message) {
        to_find_.clear();
        emit noted(message);
      });
}

/// Reads a clip first if its settings name joints, since its file may no longer have those joints.
void BatchSession::addTuned(const std::vector<TunedClip>& clips) {
  if (refused()) return;
  to_fit_.insert(to_fit_.end(), clips.begin(), clips.end());
  fitting_.start(
      [clips = to_fit_](const Job&) {
        std::vector<QueuedClip> queued;
        for (const TunedClip& clip : clips) queued.push_back(queuedClip(clip));
        return queued;
      },
      [this](const std::vector<QueuedClip>& queued) {
        to_fit_.clear();
        if (!refused()) take(queued);
      },
      [this](const QString& message) {
        to_fit_.clear();
        emit noted(message);
      });
}

void BatchSession::setSettings(const BatchSettings& settings) {
  if (settings == settings_ || running()) return;
  BatchSettings renamed = settings_;
  renamed.names = settings.names;
  const QString kind = renamed == settings ? QStringLiteral("names") : QString();  // merges typing
  const bool dresses = settings.character != settings_.character;
  history_.push(new EditStep([dresses] { return dresses ? tr("Character") : tr("Output"); },
                             [this, settings] { apply(settings); },
                             [this, before = settings_] { apply(before); }, kind));
}

void BatchSession::setCommon(const Settings& preset) {
  if (running() || preset == queue_.common()) return;
  history_.push(new EditStep(
      [] { return tr("Settings"); }, [this, preset] { queue_.setCommon(preset); },
      [this, before = queue_.common()] { queue_.setCommon(before); }, QStringLiteral("common")));
}

void BatchSession::setOwn(const std::vector<int>& rows, const std::optional<Settings>& preset) {
  std::map<int, std::optional<Settings>> before;
  QString kind = QStringLiteral("own");
  bool locks = false;
  for (const int row : rows) {
    const std::optional<Settings>& own = queue_.clips()[static_cast<std::size_t>(row)].own;
    if (own == preset) continue;
    before[row] = own;
    kind += QStringLiteral(" %1").arg(row);
    locks = locks || own.has_value() != preset.has_value();
  }
  if (running() || before.empty()) return;
  std::map<int, std::optional<Settings>> after = before;
  for (auto& [row, own] : after) own = preset;
  history_.push(new EditStep([] { return tr("Settings"); }, [this, after] { queue_.setOwn(after); },
                             [this, before] { queue_.setOwn(before); }, locks ? QString() : kind));
}

void BatchSession::remove(const std::vector<int>& rows) {
  if (running() || rows.empty()) return;
  std::map<int, QueuedClip> clips;
  for (const int row : rows) clips[row] = queue_.clips()[static_cast<std::size_t>(row)];
  history_.push(new EditStep([] { return tr("Remove Clips"); },
                             [this, rows] { queue_.remove(rows); },
                             [this, clips] { queue_.insert(clips); }));
}

void BatchSession::setLeftOut(const std::vector<int>& rows, bool left_out) {
  std::vector<int> others;
  for (const int row : rows)
    if (queue_.clips()[static_cast<std::size_t>(row)].left_out != left_out) others.push_back(row);
  if (running() || others.empty()) return;
  history_.push(
      new EditStep([left_out] { return left_out ? tr("Leave Out Clips") : tr("Export Clips Too"); },
                   [this, others, left_out] { queue_.setLeftOut(others, left_out); },
                   [this, others, left_out] { queue_.setLeftOut(others, !left_out); }));
}

/// Appends the clips that are not in the queue yet.
void BatchSession::add(const std::vector<QueuedClip>& clips) {
  std::set<QString> there;
  for (const QueuedClip& clip : queue_.clips()) there.insert(clip.key());
  std::vector<QueuedClip> fresh;
  for (const QueuedClip& clip : clips)
    if (there.insert(clip.key()).second) fresh.push_back(reviewed(clip));
  if (fresh.empty()) return;
  std::vector<int> rows(fresh.size());
  std::iota(rows.begin(), rows.end(), queue_.rowCount());
  history_.push(new EditStep([] { return tr("Add Clips"); }, [this, fresh] { queue_.add(fresh); },
                             [this, rows] { queue_.remove(rows); }));
}

void BatchSession::undo() {
  if (!running()) history_.undo();
}

void BatchSession::redo() {
  if (!running()) history_.redo();
}

/// Adds clips. Those that are in the queue already get the new settings.
void BatchSession::take(const std::vector<QueuedClip>& clips) {
  const bool new_settings = std::any_of(clips.begin(), clips.end(), [this](const auto& clip) {
    const auto& queued = queue_.clips();
    return std::any_of(queued.begin(), queued.end(), [&](const QueuedClip& one) {
      return one.key() == clip.key() && (one.own != clip.own || one.reading != clip.reading);
    });
  });
  if (!new_settings) return add(clips);
  history_.beginMacro(tr("Add Clips"));
  add(clips);
  for (const QueuedClip& clip : clips) {
    const auto& queued = queue_.clips();
    const auto at = std::find_if(queued.begin(), queued.end(),
                                 [&](const QueuedClip& one) { return one.key() == clip.key(); });
    if (at == queued.end()) continue;
    const auto row = static_cast<int>(at - queued.begin());
    if (at->reading != clip.reading)
      history_.push(
          new EditStep([] { return tr("Settings"); },
                       [this, row, after = clip.reading] { queue_.setReading(row, after); },
                       [this, row, before = at->reading] { queue_.setReading(row, before); }));
    if (at->own != clip.own) setOwn({row}, clip.own);
  }
  history_.endMacro();
}

void BatchSession::setReviews(const ClipReviews& reviews) {
  reviews_ = reviews;
  if (!running()) queue_.setReviews(reviews_);
}

/// The clip with the library's review.
QueuedClip BatchSession::reviewed(QueuedClip clip) const {
  const auto found = reviews_.find(clip.key());
  if (found == reviews_.end()) return clip;
  clip.review = found->review;
  clip.files = found->source;
  clip.missing = found->missing;
  clip.left_out = clip.review.verdict == Verdict::Rejected;
  return clip;
}

std::vector<int> BatchSession::includedRows() const {
  std::vector<int> rows;
  for (int row = 0; row < queue_.rowCount(); ++row)
    if (!queue_.clips()[static_cast<std::size_t>(row)].left_out) rows.push_back(row);
  return rows;
}

/// The batch's presets are the common one, then those of locked clips.
Batch BatchSession::batch() const {
  Batch batch{.presets = {queue_.common()},
              .formats = settings_.formats,
              .bank = settings_.bank,
              .learn = settings_.learns()};
  if (!settings_.character.isEmpty()) batch.reading.character = settings_.character.toStdString();
  const std::string names = settings_.names.toStdString();
  for (const int row : includedRows()) {
    const QueuedClip& clip = queue_.clips()[static_cast<std::size_t>(row)];
    std::size_t preset = 0;
    if (clip.own) {
      const auto found = std::find(batch.presets.begin(), batch.presets.end(), *clip.own);
      preset = static_cast<std::size_t>(found - batch.presets.begin());
      if (found == batch.presets.end()) batch.presets.push_back(*clip.own);
    }
    SourceClip source = clip.source;
    source.take = clip.reading.take.value_or(std::string());
    add_items(batch, {source}, preset, names);
    if (clip.skeleton.empty() && clip.review == ClipReview() && clip.reading == ReadOptions())
      continue;
    BatchItem item = batch.items[batch.items.size() - 1];
    item.skeleton = clip.skeleton;
    item.review = clip.review;
    if (clip.reading != ReadOptions()) {
      item.reading = clip.reading;
      if (batch.reading.character) item.reading->character = batch.reading.character;
    }
    batch.items.replace(batch.items.size() - 1, item);
  }
  mark_collisions(batch);
  return batch;
}

QString BatchSession::exampleName(bool* wrong) const {
  *wrong = false;
  const SourceClip source =
      queue_.clips().empty() ? SourceClip{"walk.bvh", "clips", {}} : queue_.clips().front().source;
  const Settings& preset = queue_.clips().empty() ? queue_.common() : queue_.presetOf(0);
  const OutputFormat format =
      settings_.formats.empty() ? OutputFormat::Mcpr : settings_.formats.front();
  try {
    const std::string output = output_name(settings_.names.toStdString(), source, preset);
    return QString::fromStdString(output + '.' + std::string(name(format)));
  } catch (const Error& error) {
    *wrong = true;
    return translatedSentence(QString::fromStdString(error.what()));
  }
}

QString BatchSession::obstacle() const {
  bool wrong = false;
  const QString example = exampleName(&wrong);
  if (queue_.clips().empty()) return tr("Add clips to begin.");
  if (queue_.countLeftOut() == queue_.rowCount())
    return tr("Every clip is left out. Tick the clips to export.");
  if (settings_.folder.isEmpty()) return tr("Choose a folder for the files.");
  if (settings_.formats.empty()) return tr("Choose at least one file format.");
  if (settings_.bank &&
      std::ranges::find(settings_.formats, OutputFormat::Mcpr) == settings_.formats.end())
    return tr("A bank needs compressed files: choose Compressed (.mcpr) too.");
  return wrong ? example : QString();
}

bool BatchSession::running() const {
  return state_ == State::Running || state_ == State::Paused || state_ == State::Stopping ||
         state_ == State::Cancelling;
}

void BatchSession::start() {
  if (running() || !obstacle().isEmpty()) return;
  rememberNow();
  running_rows_ = includedRows();
  counts_ = {};
  counts_.clips = running_rows_.size();
  time_left_ = {};
  bank_.reset();
  worked_seconds_ = 0;
  clock_.start();
  setState(State::Running);
  runner_.start(
      {batch(),
       settings_.folder,
       {.overwrite = settings_.overwrite, .resumed = true, .language = reportLanguage()}});
}

void BatchSession::pause() {
  if (state_ != State::Running) return;
  worked_seconds_ += static_cast<double>(clock_.elapsed()) / 1000;
  runner_.pause();
  setState(State::Paused);
}

void BatchSession::goOn() {
  if (state_ != State::Paused) return;
  clock_.restart();
  runner_.goOn();
  setState(State::Running);
}

void BatchSession::stopAfterCurrent() {
  if (!running()) return;
  if (state_ == State::Paused) clock_.restart();
  runner_.stopAfterCurrent();
  setState(State::Stopping);
}

void BatchSession::cancel() {
  if (!running()) return;
  runner_.cancel();
  setState(State::Cancelling);
}

void BatchSession::advance(const BatchCounts& counts, const std::vector<BatchStep>& steps) {
  counts_ = counts;
  const double now = state_ == State::Paused ? 0 : static_cast<double>(clock_.elapsed()) / 1000;
  time_left_.update(counts, worked_seconds_ + now);
  for (const BatchStep& step : steps) {
    const int row = running_rows_[step.index];
    if (!step.ended) {
      queue_.setProgress(row, step.progress);
      continue;
    }
    queue_.setEnded(row, step.measured, step.error, step.warnings);
    if (step.measured) emit exported(row, step);
  }
  emit progressed();
}

void BatchSession::end(const BatchOutcome& outcome) {
  counts_ = outcome.counts;
  queue_.stopWorking();
  for (const Warning& warning : outcome.warnings)
    emit noted(translatedSentence(QString::fromStdString(warning.text())));
  setState(outcome.complete ? State::Complete : State::Stopped);
  queue_.setReviews(reviews_);  // reviews that changed during the run
}

void BatchSession::setState(State state, const QString& failure) {
  state_ = state;
  failure_ = failure;
  emit progressed();
}

double BatchSession::fraction() const {
  if (state_ == State::Complete) return 1;
  if (counts_.bytes == 0) return 0;
  return (static_cast<double>(counts_.bytes_done) + counts_.bytes_under_way) /
         static_cast<double>(counts_.bytes);
}

QString BatchSession::report() const {
  if (settings_.folder.isEmpty()) return {};
  const QString path =
      QDir(settings_.folder).filePath(QString::fromStdString(report_name(Shard{})));
  return QFileInfo::exists(path) ? path : QString();
}

void BatchSession::writeSlurm(const QString& path, int tasks) {
  if (settings_.bank) {
    emit noted(
        tr("A cluster's tasks cannot make a bank, since none has all clips: set Bank to None to "
           "write a script."));
    return;
  }
  try {
    const QString queue = QDir(settings_.folder).filePath(QStringLiteral("queue.json"));
    const QString beside =
        QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("mocapress"));
    SlurmJob job{
        .program = QFileInfo::exists(beside) ? beside.toStdString() : std::string("mocapress"),
        .arguments = {queue.toStdString()},
        .folder = settings_.folder.toStdString(),
        .shards = tasks};
    if (settings_.overwrite) job.arguments.emplace_back("--overwrite");
    const std::string script = slurm_script(job);
    QDir().mkpath(settings_.folder);
    write_text(pathOf(queue), queue_text(batch()));
    write_text(pathOf(path), script);
    emit noted(tr("Wrote %1: submit it with sbatch.").arg(QDir::toNativeSeparators(path)));
  } catch (const Error& error) {
    emit noted(translatedSentence(QString::fromStdString(error.what())));
  }
}

}  // namespace mocapress
