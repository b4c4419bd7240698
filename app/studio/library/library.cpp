// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/library.h"

#include <QFileInfo>
#include <algorithm>
#include <map>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "core/batch/batch.h"
#include "widgets/models/library_model.h"

namespace mocapress {

void FolderSearch::search(const QString& folder) {
  folders_ << folder;
  searchNext();
}

void FolderSearch::abandon() {
  folders_.clear();
  finding_.abandon();
}

void FolderSearch::searchNext() {
  if (finding_.busy() || folders_.isEmpty()) return;
  const QString folder = folders_.takeFirst();
  // The runner is busy until its delivery has returned.
  const auto go_to_next = [this] {
    QMetaObject::invokeMethod(this, &FolderSearch::searchNext, Qt::QueuedConnection);
  };
  finding_.start(
      [folder](const Job&) {
        QStringList clips;
        for (const SourceClip& clip : find_sources({folder.toStdString()}))
          if (clip.problem.empty()) clips << QString::fromStdString(clip.path);
        return clips;
      },
      [this, folder, go_to_next](const QStringList& clips) {
        if (clips.isEmpty()) emit failed(tr("There are no clips in %1.").arg(folder));
        emit found(clips);
        go_to_next();
      },
      [this, go_to_next](const QString& message) {
        emit failed(message);
        go_to_next();
      });
}

namespace {

/// What is read from the clips' files, kept from row to row.
LibraryEntry entryOf(const ProjectClip& clip, const LibraryEntry& read) {
  LibraryEntry entry = read;
  entry.path = clip.path;
  entry.outcome = clip.outcome;
  entry.verdict = clip.verdict;
  entry.note = clip.note;
  return entry;
}

/// What a compression came to, of the kind its target is of.
double quantityOf(const DecodedClip& decoded, const EncodeOptions& options) {
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

/// And whether it met its target. Requires a distortion.
Outcome outcomeOf(const DecodedClip& decoded, const EncodeOptions& options) {
  return {decoded.ratio, decoded.distortion->eps(options.weighting), decoded.distortion->max.cm,
          decoded.compressed.motion_bytes(), reached(options.target, quantityOf(decoded, options))};
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
  connect(&session->document(), &Document::skinChanged, this, &Library::noteCharacter);
  connect(session, &Session::settled, this, &Library::noteOutcome);
  connect(&folder_search_, &FolderSearch::found, this, &Library::add);
  connect(&folder_search_, &FolderSearch::failed, this, &Library::failed);
}

void Library::leave() {
  folder_search_.abandon();
  session_->close();
  session_->forgetHistories();
  history_.clear();
  withdrawn_.clear();
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
  if (!project_.character.isEmpty()) session_->recallCharacter(project_.character);
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
      [this, clips, fresh] { *clips = takeOut(fresh); }));
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
  for (const auto& [row, clip] : clips) {
    if (project_.find(clip.path)) continue;
    const auto place = std::min<std::ptrdiff_t>(row, std::ssize(all));
    project_.clips.insert(project_.clips.begin() + place, clip);
    all.insert(all.begin() + place, entryOf(clip, {}));
    unread_.push_back(clip.path);
  }
  model_->setEntries(std::move(all));
  readNextOutline();
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

void Library::setVerdict(int row, Verdict verdict) {
  if (row < 0) return;
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  change(clip.path, {verdict, clip.note.toStdString()});
}

void Library::setNote(int row, const QString& note) {
  if (row < 0) return;
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  change(clip.path, {clip.verdict, note.toStdString()});
}

void Library::change(const QString& path, const ClipReview& review) {
  const ProjectClip* clip = project_.find(path);
  const ClipReview before{clip->verdict, clip->note.toStdString()};
  if (before == review) return;
  const auto say = [this, path](const ClipReview& now) {
    return [this, path, now] {
      ProjectClip* reviewed = project_.find(path);
      if (!reviewed) return;
      reviewed->verdict = now.verdict;
      reviewed->note = QString::fromStdString(now.note);
      show(*reviewed);
      emit currentChanged();
    };
  };
  const bool is_typed = before.verdict == review.verdict;
  history_.push(new EditStep(is_typed ? tr("Note") : tr("Verdict"), say(review), say(before),
                             is_typed ? QStringLiteral("note ") + path : QString(), kOneNoteMs));
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

std::vector<TunedClip> Library::tuned(const std::vector<int>& rows) const {
  std::vector<TunedClip> clips;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    const bool wanted =
        rows.empty() || std::count(rows.begin(), rows.end(), static_cast<int>(row)) > 0;
    const ProjectClip& clip = project_.clips[row];
    if (wanted) clips.push_back({clip.path, clip.skeleton, clip.settings, clip.reading});
  }
  return clips;
}

ClipReviews Library::reviews() const {
  ClipReviews all;
  for (const ProjectClip& clip : project_.clips)
    all.insert(clip.path, {clip.verdict, clip.note.toStdString()});
  return all;
}

void Library::show(const ProjectClip& clip) {
  const int row = model_->rowOf(clip.path);
  model_->setEntry(entryOf(clip, row >= 0 ? model_->entry(row) : LibraryEntry()));
  touch();
}

/// A motion that is opened belongs to the project from then on.
void Library::noteOpened(const QString& path, const QString& skeleton) {
  const OriginalPtr& original = session_->document().original();
  project_.current = original ? original->path : QString();
  if (original && !project_.find(original->path)) {
    ProjectClip clip{.path = original->path};
    if (path == original->path) clip.skeleton = skeleton;
    clip.settings = settingsNow();
    project_.clips.push_back(clip);
    showAsRead(clip, *original);
  }
  if (original)
    if (ProjectClip* clip = project_.find(original->path); clip->reading != original->reading) {
      clip->reading = original->reading;
      showAsRead(*clip, *original);
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
  model_->setEntry(entryOf(clip, read));
}

ProjectClip* Library::openNow() {
  const OriginalPtr& original = session_->document().original();
  return original && original->path == project_.current ? project_.find(original->path) : nullptr;
}

/// Of the clip that is open.
NamedSettings Library::settingsNow() const {
  const Document& document = session_->document();
  return namedSettings(document.settings(), *document.skeleton());
}

void Library::noteSettings() {
  ProjectClip* clip = openNow();
  if (!clip) return;
  clip->settings = settingsNow();
  touch();
}

/// One whose file is gone stays the project's: it may be back another day.
void Library::noteCharacter() {
  const QString& path = session_->document().character().path;
  if (path == project_.character) return;
  project_.character = path;
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
  const Outcome outcome = outcomeOf(*decoded, session_->document().options());
  if (clip->outcome == outcome) return;
  // What was approved is no longer what there is, until it is again.
  const auto withdrawn = withdrawn_.find(clip->path);
  const bool again = withdrawn != withdrawn_.end() && withdrawn->second.first == outcome;
  const Verdict verdict = again ? withdrawn->second.second : Verdict::None;
  if (clip->outcome) {
    if (clip->verdict != Verdict::None) withdrawn_[clip->path] = {*clip->outcome, clip->verdict};
    clip->verdict = verdict;
  }
  clip->outcome = outcome;
  show(*clip);
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
      entry.trouble = trouble;
      model_->setEntry(entry);
    }
    // The runner is busy until its delivery has returned.
    QMetaObject::invokeMethod(this, &Library::readNextOutline, Qt::QueuedConnection);
  };
  outlines_.start([path, skeleton = clip->skeleton, reading = clip->reading](
                      const Job&) { return readOutline(path, skeleton, reading); },
                  [finish](const ClipOutline& outline) { finish(outline, {}); },
                  [finish](const QString& message) { finish({}, message); });
}

}  // namespace mocapress
