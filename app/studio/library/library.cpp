// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/library.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHash>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/jobs/batch_runner.h"
#include "app/jobs/open_clip.h"
#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "app/studio/document/settings_field.h"
#include "core/batch/batch.h"
#include "core/report/verdict.h"
#include "widgets/models/display_names.h"
#include "widgets/models/library_model.h"

namespace mocapress {

namespace {

/// Makes a clip's row; facts from its file are kept from the previous row.
LibraryEntry entryOf(const ProjectClip& clip, const LibraryEntry& read) {
  LibraryEntry entry = read;
  entry.path = clip.path;
  entry.is_compressed = isCompressedFile(clip.path);
  entry.missing = clip.missing;
  entry.outcome = clip.outcome;
  entry.bytes_before = clip.bytes_before;
  entry.outdated = outdated(clip);
  entry.review = clip.review;
  entry.stale = staleVerdict(clip);
  entry.preset = clip.settings ? displayName(clip.settings->preset) : QString();
  entry.failure = clip.failure;
  return entry;
}

/// The achieved value in the unit of the clip's target.
double quantityOf(const DecodedClip& decoded, const EncodeSettings& options) {
  switch (options.target.kind) {
    case Target::Kind::Ratio:
      return decoded.ratio;
    case Target::Kind::Size:
      return static_cast<double>(decoded.compressed.motion_bytes());
    case Target::Kind::Error:
      return decoded.distortion->eps(options.weighting);
    case Target::Kind::MaxError:
      return decoded.distortion->worst(options.weighting).cm;
    case Target::Kind::Visibility:
      return decoded.visibility->worst().times_noticed();
    case Target::Kind::CoefficientRatio:
      break;
  }
  return options.target.value;
}

/// Makes the outcome, including whether the target was met. Requires a distortion.
Outcome outcomeOf(const DecodedClip& decoded, const OriginalClip& original,
                  const EncodeSettings& options, bool has_contacts) {
  Outcome outcome{decoded.ratio, decoded.distortion->eps(options.weighting),
                  decoded.distortion->max.cm, decoded.compressed.motion_bytes(),
                  reached(options.target, quantityOf(decoded, options))};
  if (decoded.footskate && has_contacts) outcome.slide_cm = decoded.footskate->total_cm;
  if (decoded.visibility) outcome.sight = decoded.visibility->sight();
  for (const Warnings* warnings : {&original.warnings, &original.of_character})
    for (const Warning& warning : *warnings)
      outcome.warnings << QString::fromStdString(warning.text());
  outcome.source = original.stamp.source;
  return outcome;
}

/// The outcome of a batch's step. Requires that the clip was measured.
Outcome outcomeOf(const BatchStep& step, const Settings& settings) {
  const Measurement& measured = *step.measured;
  Outcome outcome{measured.ratio, measured.eps_cm(settings.weighting), measured.max_error_cm,
                  measured.motion_bytes, keeps_promise(settings, measured)};
  outcome.slide_cm = measured.footskate_cm;
  if (measured.seen) outcome.sight = measured.seen->sight();
  for (const std::string& warning : step.warnings)
    outcome.warnings << QString::fromStdString(warning);
  outcome.source = step.source;
  return outcome;
}

/// The reviewer's name: the user who is logged in.
std::string userName() {
  const QString home = QDir::home().dirName();
  return qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME", home)).toStdString();
}

/// A verdict on a clip that was never compressed, and whose files had not been looked at yet, is
/// about what they were then, if they have not been written since.
void bindVerdict(ProjectClip& clip) {
  ClipReview& review = clip.review;
  if (review.verdict == Verdict::None || !review.source_hash.empty() || clip.outcome) return;
  const QDateTime given = QDateTime::fromString(QString::fromStdString(review.time), Qt::ISODate);
  if (given.isValid() && clip.stamp.newest_ns / 1'000'000'000 <= given.toSecsSinceEpoch())
    review.source_hash = clip.stamp.source;
}

QHash<QString, int> rowsByPath(const Project& project) {
  QHash<QString, int> rows;
  for (std::size_t row = 0; row < project.clips.size(); ++row)
    rows.insert(project.clips[row].path, static_cast<int>(row));
  return rows;
}

}  // namespace

Library::Library(Session* session, LibraryModel* model, QObject* parent)
    : KeptProject(parent), session_(session), model_(model) {
  connect(this, &Library::leaving, this, &Library::leave);
  connect(this, &Library::entered, this, &Library::enter);
  session->setMemory([this](const QString& path) {
    const ProjectClip* clip = project_.find(path);
    return clip ? clip->settings : std::nullopt;
  });
  session->setReadingMemory([this](const QString& path) {
    const ProjectClip* clip = project_.find(path);
    return clip ? clip->reading : ReadOptions();
  });
  connect(session, &Session::opened, this,
          [this](const OpenRequest& request) { noteOpened(request.path, request.skeleton); });
  connect(&session->document(), &Document::optionsChanged, this, &Library::noteSettings);
  connect(&session->document(), &Document::skinChanged, this, &Library::noteCharacters);
  connect(session, &Session::settled, this, &Library::noteOutcome);
  connect(session, &Session::openFailed, this, &Library::noteOpenFailed);
  connect(&folder_search_, &FolderSearch::found, this, &Library::add);
  connect(&folder_search_, &FolderSearch::failed, this, &Library::failed);
}

void Library::leave() {
  folder_search_.abandon();
  session_->close();
  session_->forgetHistories();
  history_.clear();
  checking_.abandon();
  check_again_ = false;
  finding_.abandon();
  reading_character_.abandon();
  known_.clear();
}

void Library::enter() {
  std::vector<LibraryEntry> entries;
  unread_.clear();
  for (const ProjectClip& clip : project_.clips) {
    entries.push_back(entryOf(clip, {}));
    unread_.push_back(clip.path);
  }
  model_->setEntries(std::move(entries));
  readNextOutline();
  emit currentChanged();
  checkFiles();
  session_->recallCharacters(project_.characters);
  if (const int row = currentRow(); row >= 0) openClip(row);
}

void Library::add(const QStringList& paths) {
  QSet<QString> known;
  for (const ProjectClip& clip : project_.clips) known.insert(clip.path);
  auto clips = std::make_shared<ClipsByRow>();  // as they are when they are taken out again
  QSet<QString> fresh;
  for (const QString& each : paths) {
    const QString path = QFileInfo(each).absoluteFilePath();
    if (known.contains(path)) continue;
    known.insert(path);
    fresh.insert(path);
    clips->emplace(static_cast<int>(project_.clips.size() + clips->size()),
                   ProjectClip{.path = path});
  }
  if (fresh.isEmpty()) return;
  const int first = clips->begin()->first;
  history_.push(new EditStep(
      tr("Add Clips"), [this, clips] { putBack(*clips); },
      [this, clips, fresh] {
        *clips = takeOut(fresh);
        emit noted(tr("%Ln clip(s) were taken out of the library; Redo brings them back.", nullptr,
                      static_cast<int>(clips->size())));
      }));
  emit added(first);
}

void Library::addFolder(const QString& path) {
  folder_search_.search(path);
}

void Library::remove(const QList<int>& rows) {
  if (rows.isEmpty()) return;
  QSet<QString> paths;
  for (const int row : rows) paths.insert(project_.clips[static_cast<std::size_t>(row)].path);
  auto clips = std::make_shared<ClipsByRow>();
  history_.push(new EditStep(
      tr("Remove Clip"), [this, clips, paths] { *clips = takeOut(paths); },
      [this, clips] { putBack(*clips); }));
}

std::vector<LibraryEntry> Library::entries() const {
  std::vector<LibraryEntry> entries;
  for (int row = 0; row < model_->rowCount(); ++row) entries.push_back(model_->entry(row));
  return entries;
}

Library::ClipsByRow Library::takeOut(const QSet<QString>& paths) {
  ClipsByRow clips;
  for (std::size_t row = 0; row < project_.clips.size(); ++row)
    if (const ProjectClip& clip = project_.clips[row]; paths.contains(clip.path))
      clips.emplace(static_cast<int>(row), clip);
  const auto is_out = [&](const auto& one) { return paths.contains(one.path); };
  std::erase_if(project_.clips, is_out);
  std::vector<LibraryEntry> left = entries();
  std::erase_if(left, is_out);
  model_->setEntries(std::move(left));
  touch();
  emit currentChanged();
  return clips;
}

/// With all that was decided about them, where they were: the first row first.
void Library::putBack(const ClipsByRow& clips) {
  std::vector<LibraryEntry> all = entries();
  const QHash<QString, int> known = rowsByPath(project_);
  for (const auto& [row, clip] : clips) {
    if (known.contains(clip.path)) continue;
    const auto place = std::min<std::ptrdiff_t>(row, std::ssize(all));
    project_.clips.insert(project_.clips.begin() + place, clip);
    all.insert(all.begin() + place, entryOf(clip, {}));
    unread_.push_back(clip.path);
  }
  model_->setEntries(std::move(all));
  readNextOutline();
  checkFiles();
  touch();
  emit currentChanged();
}

void Library::openClip(int row) {
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  session_->open(clip.path, clip.skeleton);
}

int Library::currentRow() const {
  const auto found =
      std::find_if(project_.clips.begin(), project_.clips.end(),
                   [this](const ProjectClip& clip) { return clip.path == project_.current; });
  return found == project_.clips.end() ? -1 : static_cast<int>(found - project_.clips.begin());
}

namespace {

std::string timeNow() {
  return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

}  // namespace

/// The reviewer has seen what the row shows.
ClipReview Library::reviewNow(const ProjectClip& clip, Verdict verdict) const {
  ClipReview review{.verdict = verdict, .note = clip.review.note, .notes = clip.review.notes};
  if (verdict == Verdict::None) return review;
  review.reviewer = userName();
  review.time = timeNow();
  const bool is_open = session_->isOpen(clip.path);
  review.source_hash = is_open        ? session_->document().original()->stamp.source
                       : clip.outcome ? clip.outcome->source
                                      : clip.stamp.source;
  review.settings_hash = !is_open && clip.outcome ? clip.outcome->settings : settingsHash(clip);
  return review;
}

void Library::setVerdict(const std::vector<int>& rows, Verdict verdict) {
  Reviews before, after;
  int missing = 0;
  for (const int row : rows) {
    const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
    const bool stands = clip.review.verdict == verdict && staleVerdict(clip) == Staleness::None;
    if (stands) continue;
    if (verdict != Verdict::None && clip.missing) {
      ++missing;
      continue;
    }
    before.emplace(clip.path, clip.review);
    after.emplace(clip.path, reviewNow(clip, verdict));
  }
  if (!after.empty())
    history_.push(new EditStep(
        tr("Verdict"), [this, after] { apply(after); }, [this, before] { apply(before); }));
  if (missing == 0) return;
  emit failed(tr("No verdict for %Ln clip(s): the file is missing.", nullptr, missing));
  emit currentChanged();  // what stands is shown again
}

void Library::setNote(int row, const QString& note) {
  if (row < 0) return;
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  ClipReview review = clip.review;
  review.note = note.toStdString();
  if (review == clip.review) return;
  const Reviews before{{clip.path, clip.review}}, after{{clip.path, review}};
  history_.push(new EditStep(
      tr("Note"), [this, after] { apply(after); }, [this, before] { apply(before); },
      QStringLiteral("note ") + clip.path, kOneNoteMs));
}

std::vector<FrameNote> Library::frameNotes(int row) const {
  if (row < 0) return {};
  return project_.clips[static_cast<std::size_t>(row)].review.notes;
}

void Library::setFrameNote(int row, int index, const FrameNote& note) {
  if (row < 0 || row >= std::ssize(project_.clips)) return;
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  ClipReview review = clip.review;
  if (index >= std::ssize(review.notes)) return;
  if (index >= 0) review.notes.erase(review.notes.begin() + index);
  if (!note.text.empty()) {
    FrameNote written = note;
    written.reviewer = userName();
    written.time = timeNow();
    const auto place =
        std::upper_bound(review.notes.begin(), review.notes.end(), written,
                         [](const FrameNote& a, const FrameNote& b) { return a.frame < b.frame; });
    review.notes.insert(place, written);
  }
  if (review == clip.review) return;
  const Reviews before{{clip.path, clip.review}}, after{{clip.path, review}};
  history_.push(new EditStep(
      tr("Note"), [this, after] { apply(after); }, [this, before] { apply(before); }));
}

void Library::apply(const Reviews& reviews) {
  std::vector<int> rows;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    ProjectClip& clip = project_.clips[row];
    const auto found = reviews.find(clip.path);
    if (found == reviews.end()) continue;
    clip.review = found->second;
    bindVerdict(clip);
    rows.push_back(static_cast<int>(row));
  }
  showRows(rows);
  emit currentChanged();
}

void Library::setPreset(const std::vector<int>& rows, const Settings& preset) {
  change(rows, tr("Preset"), [&](NamedSettings& settings) {
    const Settings before = std::exchange(settings.preset, preset);
    if (!preset.contacts) settings.preset.contacts = before.contacts;
    if (preset.ranges.empty()) settings.preset.ranges = before.ranges;
    if (!preset.loop) settings.preset.loop = before.loop;
  });
}

void Library::copySettings(int row) {
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  copied_ = clip.settings.value_or(NamedSettings{usualPreset(), {}});
}

void Library::pasteSettings(const std::vector<int>& rows) {
  if (!copied_) return;
  change(rows, tr("Paste Settings"), [this](NamedSettings& settings) {
    const Settings before = settings.preset;
    settings = *copied_;
    settings.preset.contacts = before.contacts;
    settings.preset.ranges = before.ranges;
    settings.preset.loop = before.loop;
  });
}

void Library::pasteImportance(const std::vector<int>& rows) {
  if (!copied_) return;
  change(rows, tr("Paste Importance"), [this](NamedSettings& settings) {
    settings.preset.importance = copied_->preset.importance;
  });
}

/// In one step. Clips that were never tuned begin with the usual settings.
void Library::change(const std::vector<int>& rows, const QString& name,
                     const std::function<void(NamedSettings&)>& change) {
  SettingsByPath before, after;
  for (const int row : rows) {
    const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
    NamedSettings settings = clip.settings.value_or(NamedSettings{usualPreset(), {}});
    change(settings);
    if (clip.settings && settings.preset == clip.settings->preset &&
        settings.contacts == clip.settings->contacts)
      continue;
    before.emplace(clip.path, clip.settings);
    after.emplace(clip.path, settings);
  }
  if (after.empty()) return;
  const QString text =
      after.size() == 1 ? name
                        : tr("%1, %Ln Clip(s)", nullptr, static_cast<int>(after.size())).arg(name);
  history_.push(new EditStep(
      text, [this, after] { apply(after); }, [this, before] { apply(before); }));
}

void Library::putCharacter(const std::vector<int>& rows, const QString& file) {
  std::set<std::string> rigs;
  for (const int row : rows)
    if (const std::string& rig = project_.clips[static_cast<std::size_t>(row)].rig; !rig.empty())
      rigs.insert(rig);
  if (rigs.empty()) return;
  const auto put_on = [this, rigs](const std::optional<PutCharacter>& put) {
    Session::CharacterChanges before, after;
    const Characters& now = session_->document().characters();
    for (const std::string& rig : rigs) {
      const auto found = now.find(rig);
      before[rig] = found == now.end() ? std::nullopt : std::optional(found->second);
      after[rig] = put;
    }
    history_.push(new EditStep(
        tr("Character"), [this, after] { session_->putCharacters(after); },
        [this, before] { session_->putCharacters(before); }));
  };
  if (file.isEmpty()) return put_on(std::nullopt);
  reading_character_.start(
      [path = QFileInfo(file).absoluteFilePath()](const Job&) {
        return PutCharacter{read_character(path.toStdU16String()), path, {}};
      },
      put_on, [this](const QString& message) { emit failed(message); });
}

void Library::apply(const SettingsByPath& settings) {
  std::vector<int> rows;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    ProjectClip& clip = project_.clips[row];
    const auto found = settings.find(clip.path);
    if (found == settings.end()) continue;
    clip.bytes_before.reset();
    if (clip.outcome && outdated(clip) == Staleness::None)
      clip.bytes_before = clip.outcome->motion_bytes;
    clip.settings = found->second;
    clip.failure.clear();
    recallOutcome(clip);
    rows.push_back(static_cast<int>(row));
  }
  showRows(rows);
  if (const ProjectClip* open = openNow(); open && open->settings && settings.count(open->path) > 0)
    session_->takeSettings(settingsFor(*open->settings, session_->document().original()->motion()));
  emit currentChanged();
}

void Library::checkFiles() {
  check_again_ = checking_.busy();
  if (check_again_ || project_.clips.empty()) return;
  std::vector<ClipSource> sources;
  for (const ProjectClip& clip : project_.clips)
    sources.push_back({clip.path, clip.skeleton, clip.stamp});
  checking_.start([sources](const Job& job) { return lookAt(sources, job); },
                  [this, sources](const std::vector<SourceNow>& now) {
                    noteFiles(sources, now);
                    emit looked();
                    // The runner is busy until its delivery has returned.
                    if (check_again_)
                      QMetaObject::invokeMethod(this, &Library::checkFiles, Qt::QueuedConnection);
                  },
                  [this](const QString& message) { emit failed(message); });
}

void Library::noteFiles(const std::vector<ClipSource>& sources, const std::vector<SourceNow>& now) {
  const QHash<QString, int> rows = rowsByPath(project_);
  std::vector<int> others;
  int changed = 0, missing = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const int row = rows.value(sources[i].path, -1);
    if (row < 0) continue;
    ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
    if (clip.stamp.hash != sources[i].stamp.hash) continue;  // opened since: that is newer
    const bool was_missing = std::exchange(clip.missing, now[i].state == SourceNow::State::Missing);
    const bool is_new = now[i].state == SourceNow::State::Found &&
                        (was_missing || now[i].stamp.hash != clip.stamp.hash);
    if (is_new && (was_missing || !clip.stamp.hash.empty())) unread_.push_back(clip.path);
    if (is_new && !was_missing && !clip.stamp.hash.empty()) ++changed;
    if (clip.missing && !was_missing) ++missing;
    if (now[i].state == SourceNow::State::Found) clip.stamp = now[i].stamp;
    if (is_new) clip.failure.clear();
    bindVerdict(clip);
    if (is_new || clip.missing != was_missing) others.push_back(row);
  }
  showRows(others);
  readNextOutline();
  if (!others.empty()) emit currentChanged();
  if (changed > 0) emit noted(tr("The files of %Ln clip(s) have changed.", nullptr, changed));
  if (missing > 0)
    emit noted(
        tr("The files of %Ln clip(s) are missing. The library's context menu finds them in "
           "another folder.",
           nullptr, missing));
  openIfChanged();
}

/// Each content of a file once: a file that cannot be read, or takes longer than the time between
/// two looks, is not opened over and over.
void Library::openIfChanged() {
  const ProjectClip* open = openNow();
  if (!open || open->missing || session_->isOpening()) return;
  const std::string& hash = open->stamp.hash;
  if (hash == session_->document().original()->stamp.hash || hash == tried_) return;
  tried_ = hash;
  session_->open(open->path, open->skeleton);
}

void Library::lookAgain() {
  if (!checking_.busy()) checkFiles();
}

void Library::findMissing(const QString& folder) {
  std::vector<ClipSource> missing;
  for (const ProjectClip& clip : project_.clips)
    if (clip.missing) missing.push_back({clip.path, clip.skeleton, clip.stamp});
  finding_.start(
      [folder, missing](const Job& job) { return findMoved(folder, missing, job); },
      [this, missing](std::map<QString, ClipSource> moved) {
        const QHash<QString, int> rows = rowsByPath(project_);
        std::erase_if(moved, [&](const auto& one) {
          return !rows.contains(one.first) || rows.contains(one.second.path);
        });
        std::map<QString, ClipSource> back;
        for (const ClipSource& clip : missing)
          if (const auto found = moved.find(clip.path); found != moved.end())
            back.emplace(found->second.path, clip);
        const auto left = static_cast<int>(missing.size() - moved.size());
        if (!moved.empty())
          history_.push(new EditStep(
              tr("Find Clips"), [this, moved] { move(moved); }, [this, back] { move(back); }));
        emit noted(tr("Found %Ln clip(s)", nullptr, static_cast<int>(moved.size())) +
                   (left > 0 ? tr(", %Ln still missing", nullptr, left) : QString()));
      },
      [this](const QString& message) { emit failed(message); });
}

/// The clips stay what they are, with their files elsewhere.
void Library::move(const std::map<QString, ClipSource>& to) {
  std::vector<LibraryEntry> all = entries();
  bool current_moves = false;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    ProjectClip& clip = project_.clips[row];
    const auto found = to.find(clip.path);
    if (found == to.end()) continue;
    if (clip.path == project_.current) {
      project_.current = found->second.path;
      current_moves = true;
    }
    clip.path = found->second.path;
    clip.skeleton = found->second.skeleton;
    clip.stamp = found->second.stamp;
    clip.missing = false;
    all[row] = entryOf(clip, all[row]);
    all[row].trouble.clear();
    unread_.push_back(clip.path);
  }
  model_->setEntries(std::move(all));
  readNextOutline();
  checkFiles();
  touch();
  emit currentChanged();
  if (current_moves) openClip(currentRow());
}

void Library::noteExported(const QString& path, const Settings& settings,
                           const ReadOptions& reading, const BatchStep& step) {
  ProjectClip* clip = project_.find(path);
  if (!clip || !step.measured) return;
  if (!clip->settings) clip->settings = NamedSettings{settings, {}};
  Outcome outcome = outcomeOf(step, settings);
  outcome.settings = settings_hash(settings, reading);
  if (settingsHash(*clip) != outcome.settings) return;
  setOutcome(*clip, outcome);
}

void Library::setOutcome(ProjectClip& clip, const Outcome& outcome) {
  known_[{outcome.source, outcome.settings}] = outcome;
  clip.outcome = outcome;
  clip.failure.clear();
  show(clip);
  if (clip.path == project_.current) emit currentChanged();
}

/// Settings that the clip had before came to the same.
void Library::recallOutcome(ProjectClip& clip) {
  const auto found = known_.find({clip.stamp.source, settingsHash(clip)});
  if (found != known_.end()) clip.outcome = found->second;
}

std::vector<TunedClip> Library::unencoded(std::size_t most) const {
  std::vector<TunedClip> clips;
  const auto count = static_cast<int>(project_.clips.size());
  const int first = std::max(currentRow(), 0);
  for (int i = 0; i < count && clips.size() < most; ++i) {
    const int row = (first + i) % count;
    const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
    if (!model_->entry(row).wantsEncoding() || session_->isOpen(clip.path)) continue;
    clips.push_back(tunedClip(project_, clip));
    if (!clips.back().settings) clips.back().settings = NamedSettings{usualPreset(), {}};
  }
  return clips;
}

void Library::noteEncoded(const TunedClip& tuned, const BatchStep& step) {
  ProjectClip* clip = project_.find(tuned.path);
  if (!clip || session_->isOpen(tuned.path)) return;
  if (step.measured) {
    noteExported(tuned.path, tuned.settings->preset, tuned.reading, step);
  } else {
    const std::string made_by = settings_hash(tuned.settings->preset, tuned.reading);
    if (clip->settings && settingsHash(*clip) != made_by) return;  // it has others by now
    clip->failure = QString::fromStdString(step.error);
    show(*clip);
  }
  if (step.source.empty() || step.source == clip->stamp.source) return;
  clip->failure =
      tr("The clip's files changed while it was compressed.");  // until they are looked at
  show(*clip);
  checkFiles();
}

std::vector<Pin> Library::pinsOf(const QString& path) {
  const ProjectClip* clip = project_.find(path);
  return clip ? clip->pins : std::vector<Pin>();
}

void Library::setPins(const QString& path, const std::vector<Pin>& pins) {
  ProjectClip* clip = project_.find(path);
  if (!clip) return;
  clip->pins = pins;
  touch();
}

void Library::setBatch(const RememberedBatch& batch) {
  project_.batch = batch;
  touch();
}

std::vector<TunedClip> Library::tuned(const std::vector<int>& rows) const {
  std::vector<TunedClip> clips;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    const bool wanted =
        rows.empty() || std::count(rows.begin(), rows.end(), static_cast<int>(row)) > 0;
    const ProjectClip& clip = project_.clips[row];
    if (!wanted) continue;
    clips.push_back(tunedClip(project_, clip));
  }
  return clips;
}

TunedClip Library::tunedClip(const Project& project, const ProjectClip& clip) {
  TunedClip tuned{clip.path, clip.skeleton, clip.settings, clip.reading};
  if (const QString file = characterFile(project.characters, clip.rig); !file.isEmpty())
    tuned.reading.character = file.toStdString();
  return tuned;
}

ClipReviews Library::reviews() const {
  ClipReviews all;
  for (const ProjectClip& clip : project_.clips)
    all.insert(clip.path, {clip.review, clip.stamp.source, clip.missing});
  return all;
}

std::vector<std::string> Library::remarksOn(const QString& path) const {
  std::vector<std::string> remarks;
  for (const ProjectClip& clip : project_.clips) {
    if (clip.path != path) continue;
    remarks = {
        verdict_text(clip.review, stale_reason(clip.review, clip.stamp.source, settingsHash(clip))),
        clip.review.note};
    for (const FrameNote& note : clip.review.notes) remarks.push_back(note_text(note));
  }
  std::erase(remarks, "");
  return remarks;
}

void Library::show(const ProjectClip& clip) {
  const int row = model_->rowOf(clip.path);
  model_->setEntry(entryOf(clip, row >= 0 ? model_->entry(row) : LibraryEntry()));
  touch();
}

void Library::showRows(const std::vector<int>& rows) {
  std::map<int, LibraryEntry> entries;
  for (const int row : rows)
    entries.emplace(row,
                    entryOf(project_.clips[static_cast<std::size_t>(row)], model_->entry(row)));
  model_->replace(entries);
  if (!rows.empty()) touch();
}

/// A motion that is opened belongs to the project from then on.
void Library::noteOpened(const QString& path, const QString& skeleton) {
  const OriginalPtr& original = session_->document().original();
  project_.current = original ? original->path : QString();
  if (original && !project_.find(original->path)) {
    ProjectClip clip{.path = original->path};
    if (path == original->path) clip.skeleton = skeleton;
    clip.settings = settingsNow();
    clip.stamp = original->stamp;
    project_.clips.push_back(clip);
    showAsRead(clip, *original);
  }
  if (original) {
    ProjectClip* clip = project_.find(original->path);
    const bool is_other = clip->missing || clip->reading != original->reading ||
                          clip->stamp.hash != original->stamp.hash;
    clip->missing = false;
    clip->reading = original->reading;
    clip->stamp = original->stamp;
    clip->rig = original->outline.rig;
    bindVerdict(*clip);
    if (is_other) showAsRead(*clip, *original);
  }
  touch();
  emit currentChanged();
}

void Library::showAsRead(const ProjectClip& clip, const OriginalClip& original) {
  const ClipOutline& outline = original.outline;
  LibraryEntry read;
  read.frames = outline.frames;
  read.sample_rate_hz = outline.sample_rate_hz;
  read.outline = outline.bones;
  read.skin = outline.skin;
  read.loop = outline.loop;
  for (const Warning& warning : original.warnings)
    read.notes << QString::fromStdString(warning.text());
  model_->setEntry(entryOf(clip, read));
}

ProjectClip* Library::openNow() {
  const OriginalPtr& original = session_->document().original();
  return original && original->path == project_.current ? project_.find(original->path) : nullptr;
}

/// Whether the clip that is open has these.
bool Library::isAsNow(const NamedSettings& settings) const {
  const Document& document = session_->document();
  return firstDifference(settingsFor(settings, document.original()->motion()),
                         document.settings()) == SettingsField::None;
}

/// Of the clip that is open.
NamedSettings Library::settingsNow() const {
  const Document& document = session_->document();
  NamedSettings settings = namedSettings(document.settings(), *document.skeleton());
  // A preset as it is, not in the names of this clip's joints: as a batch has it.
  for (const Settings& preset : built_in_presets()) {
    if (preset.name != settings.preset.name ||
        !isAsPreset(document.settings(), preset, *document.skeleton()))
      continue;
    const Settings own = std::exchange(settings.preset, preset);
    settings.preset.contacts = own.contacts;
    settings.preset.ranges = own.ranges;
    settings.preset.loop = own.loop;
  }
  return settings;
}

void Library::noteSettings() {
  ProjectClip* clip = openNow();
  if (!clip) return;
  const auto state = [clip] { return std::pair(staleVerdict(*clip), outdated(*clip)); };
  const auto before = state();
  // Those it was opened by stay as they were said.
  if (clip->settings && isAsNow(*clip->settings)) return;
  clip->settings = settingsNow();
  clip->failure.clear();
  touch();
  if (state() == before) return;
  show(*clip);
  emit currentChanged();
}

/// One whose file is gone stays the project's: it may be back another day.
void Library::noteCharacters() {
  CharacterFiles files = filesOf(session_->document().characters());
  if (files == project_.characters) return;
  project_.characters = std::move(files);
  touch();
}

void Library::setShowsSkin(bool shows) {
  if (shows == project_.shows_skin) return;
  project_.shows_skin = shows;
  touch();
}

void Library::noteOutcome() {
  ProjectClip* clip = openNow();
  const DecodedPtr& decoded = session_->document().decoded();
  if (!clip || !decoded || !decoded->distortion) return;
  if (!clip->settings) {  // opened as it came: what it came to is by these from now on
    clip->settings = settingsNow();
    touch();
  }
  Outcome outcome =
      outcomeOf(*decoded, *session_->document().original(), session_->document().options(),
                !session_->document().contacts().empty());
  outcome.settings = settingsHash(*clip);
  if (clip->outcome != outcome) setOutcome(*clip, outcome);
}

/// The view does not stay on the clip before: what is said of the chosen clip would seem to be said
/// of that one.
void Library::noteOpenFailed(const OpenRequest& request, const QString& message) {
  const int row = model_->rowOf(request.path);
  if (row < 0 || request.compare) return;
  ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  clip.missing = !QFileInfo::exists(clip.path);
  if (!session_->isOpen(request.path)) {
    session_->closeClip();
    project_.current = clip.path;
  }
  LibraryEntry entry = entryOf(clip, model_->entry(row));
  entry.trouble = message;
  model_->setEntry(entry);
  touch();
  emit currentChanged();
}

void Library::readNextOutline() {
  if (outlines_.busy() || unread_.empty()) return;
  const QString path = unread_.front();
  unread_.pop_front();
  const ProjectClip* clip = project_.find(path);
  if (!clip) return readNextOutline();
  const auto finish = [this, path](const ClipOutline& outline, const QString& trouble) {
    if (const int row = model_->rowOf(path); row >= 0) {
      LibraryEntry entry = model_->entry(row);
      entry.frames = outline.frames;
      entry.sample_rate_hz = outline.sample_rate_hz;
      entry.outline = outline.bones;
      entry.skin = outline.skin;
      entry.loop = outline.loop;
      entry.notes = outline.notes;
      entry.trouble = trouble;
      model_->setEntry(entry);
    }
    if (ProjectClip* now = project_.find(path); now && !outline.rig.empty())
      if (std::exchange(now->rig, outline.rig) != outline.rig) touch();
    // The runner is busy until its delivery has returned.
    QMetaObject::invokeMethod(this, &Library::readNextOutline, Qt::QueuedConnection);
  };
  outlines_.start([path, skeleton = clip->skeleton, reading = clip->reading](
                      const Job&) { return readOutline(path, skeleton, reading); },
                  [finish](const ClipOutline& outline) { finish(outline, {}); },
                  [finish](const QString& message) { finish({}, message); });
}

}  // namespace mocapress
