// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/library.h"

#include <QFileInfo>
#include <QSet>
#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "app/jobs/open_clip.h"
#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "widgets/models/display_names.h"
#include "widgets/models/library_model.h"

namespace mocapress {

LibraryEntry Library::entryOf(const ProjectClip& clip, const LibraryEntry& read) {
  LibraryEntry entry = read;
  entry.path = clip.path;
  entry.take = clip.reading.take;
  entry.is_compressed = isCompressedFile(clip.path);
  entry.missing = clip.missing;
  entry.outcome = clip.outcome;
  entry.bytes_before = clip.bytes_before;
  entry.since = differenceSince(clip);
  entry.outdated = outdated(clip);
  entry.review = clip.review;
  entry.stale = staleVerdict(clip);
  entry.preset = clip.settings ? displayName(clip.settings->preset) : QString();
  entry.failure = clip.failure;
  return entry;
}

Library::Library(Session* session, LibraryModel* model, QObject* parent)
    : KeptProject(parent), session_(session), model_(model) {
  connect(this, &Library::leaving, this, &Library::leave);
  connect(this, &Library::entered, this, &Library::enter);
  session->setMemory([this](const QString& key) {
    const ProjectClip* clip = project_.find(key);
    return clip ? clip->settings : std::nullopt;
  });
  session->setReadingMemory([this](const QString& path) {
    const ProjectClip* clip = project_.findFile(path);
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
  connect(&outlines_, &OutlineReader::read, this, &Library::noteOutline);
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
  comparing_.abandon();
  earlier_.clear();
  carrying_notes_.abandon();
  reading_new_notes_.abandon();
  new_.clear();
  known_.clear();
}

void Library::enter() {
  std::vector<LibraryEntry> entries;
  outlines_.clear();
  for (const ProjectClip& clip : project_.clips) {
    entries.push_back(entryOf(clip, {}));
    outlines_.add(clip.key());
  }
  model_->setEntries(std::move(entries));
  emit currentChanged();
  checkFiles();
  session_->recallCharacters(project_.characters);
  if (const int row = currentRow(); row >= 0) openClip(row);
}

void Library::announce() {
  std::vector<int> rows(project_.clips.size());
  std::iota(rows.begin(), rows.end(), 0);
  showRows(rows);
  emit currentChanged();
  emit projectChanged();
  if (!earlier_.isEmpty()) emit compared();
}

void Library::add(const QStringList& paths) {
  QSet<QString> known;
  known.reserve(std::ssize(project_.clips) + paths.size());  // thousands are added at once
  for (const ProjectClip& clip : project_.clips) known.insert(clip.path);
  auto clips = std::make_shared<ClipsByRow>();  // undo stores the removed clips here for redo
  const auto end = static_cast<int>(project_.clips.size());
  for (const QString& each : paths) {
    const QString path = QFileInfo(each).absoluteFilePath();
    const qsizetype before = known.size();
    known.insert(path);
    if (known.size() == before) continue;
    const int row = end + static_cast<int>(clips->size());
    clips->try_emplace(clips->end(), row)->second.path = path;
  }
  if (clips->empty()) return;
  const int first = clips->begin()->first;
  history_.push(new EditStep(
      [] { return tr("Add Clips"); }, [this, clips] { putBack(*clips); },
      [this, clips] {
        QSet<QString> added;
        for (const auto& [row, clip] : *clips) added.insert(clip.path);
        *clips = takeOut([&added](const auto& one) { return added.contains(one.path); });
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
  QSet<QString> keys;
  for (const int row : rows) keys.insert(project_.clips[static_cast<std::size_t>(row)].key());
  auto clips = std::make_shared<ClipsByRow>();
  history_.push(new EditStep([] { return tr("Remove Clip"); },
                             [this, clips, keys] {
                               *clips = takeOut(
                                   [&keys](const auto& one) { return keys.contains(one.key()); });
                             },
                             [this, clips] { putBack(*clips); }));
}

std::vector<LibraryEntry> Library::entries() const {
  std::vector<LibraryEntry> entries;
  for (int row = 0; row < model_->rowCount(); ++row) entries.push_back(model_->entry(row));
  return entries;
}

template <typename IsOut>
Library::ClipsByRow Library::takeOut(const IsOut& is_out) {
  ClipsByRow clips;
  for (std::size_t row = 0; row < project_.clips.size(); ++row)
    if (const ProjectClip& clip = project_.clips[row]; is_out(clip))
      clips.emplace(static_cast<int>(row), clip);
  std::erase_if(project_.clips, is_out);
  std::vector<LibraryEntry> left = entries();
  std::erase_if(left, is_out);
  model_->setEntries(std::move(left));
  touch();
  emit currentChanged();
  return clips;
}

/// Inserts removed clips again at their old rows, with their settings and reviews, in the order of
/// rows.
void Library::putBack(const ClipsByRow& clips) {
  std::vector<LibraryEntry> all = entries();
  const QHash<QString, int> known = project_.rows();
  project_.clips.reserve(project_.clips.size() + clips.size());
  all.reserve(all.size() + clips.size());
  for (const auto& [row, clip] : clips) {
    if (known.contains(clip.key())) continue;
    const auto place = std::min<std::ptrdiff_t>(row, std::ssize(all));
    project_.clips.insert(project_.clips.begin() + place, clip);
    all.insert(all.begin() + place, entryOf(clip, {}));
    outlines_.add(clip.key());
  }
  if (findEarlier())  // the batch to compare with may have changed meanwhile
    for (std::size_t row = 0; row < all.size(); ++row)
      all[row].since = differenceSince(project_.clips[row]);
  model_->setEntries(std::move(all));
  checkFiles();
  touch();
  emit currentChanged();
}

void Library::openClip(int row) {
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  session_->open(clip.path, clip.skeleton, clip.reading);
}

int Library::currentRow() const {
  const auto found =
      std::find_if(project_.clips.begin(), project_.clips.end(),
                   [this](const ProjectClip& clip) { return clip.key() == project_.current; });
  return found == project_.clips.end() ? -1 : static_cast<int>(found - project_.clips.begin());
}

QString Library::clipFolder() const {
  const auto row = static_cast<std::size_t>(std::max(currentRow(), 0));
  return row < project_.clips.size() ? QFileInfo(project_.clips[row].path).path() : QString();
}

std::vector<Pin> Library::pinsOf(const QString& key) {
  const ProjectClip* clip = project_.find(key);
  return clip ? clip->pins : std::vector<Pin>();
}

void Library::setPins(const QString& key, const std::vector<Pin>& pins) {
  ProjectClip* clip = project_.find(key);
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

void Library::show(const ProjectClip& clip) {
  const int row = model_->rowOf(clip.key());
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

/// Makes the opened motion the current clip, and adds it to the project if it is new.
void Library::noteOpened(const QString& path, const QString& skeleton) {
  const OriginalPtr& original = session_->document().original();
  if (original) {
    noteTakes(original->path, original->takes);
    ProjectClip* clip = project_.find(session_->openKey());
    const bool is_fresh = !clip;
    const bool is_first = !project_.findFile(original->path);
    if (is_fresh) {
      clip = &project_.clips.emplace_back(ProjectClip{.path = original->path});
      if (path == original->path) clip->skeleton = skeleton;
    }
    const bool is_other = is_fresh || clip->missing || clip->reading != original->reading ||
                          clip->stamp.hash != original->stamp.hash;
    clip->missing = false;
    clip->reading = original->reading;
    clip->stamp = original->stamp;
    clip->rig = original->outline.rig;
    if (is_fresh) clip->settings = settingsNow();
    if (is_fresh) findEarlier();
    bindVerdict(*clip);
    if (is_other) showAsRead(*clip, *original);
    if (is_first) readNotesOfNew(original->path);
    if (is_first) addTakes(static_cast<int>(project_.clips.size()) - 1, original->takes);
  }
  project_.current = session_->openKey();
  touch();
  emit currentChanged();
}

/// Called when a file is read for the first time: notes which take its clip is, and adds the
/// others.
void Library::noteTakes(const QString& path, const Takes& takes) {
  ProjectClip* clip = project_.find(path);
  if (!clip || takes.keys.size() < 2) return;
  const int row = model_->rowOf(path);
  clip->reading.take = takeAmong(takes);
  if (project_.current == path) project_.current = clip->key();
  if (row >= 0) addTakes(row, takes);
}

/// Adds the other takes of a row's file as rows below it.
void Library::addTakes(int row, const Takes& takes) {
  if (takes.keys.size() < 2) return;
  const QHash<QString, int> known = project_.rows();
  const ProjectClip first = project_.clips[static_cast<std::size_t>(row)];
  std::vector<ProjectClip> others;
  for (const std::string& take : takes.keys) {
    ProjectClip clip{.path = first.path, .skeleton = first.skeleton, .reading = first.reading};
    clip.reading.take = take;
    clip.stamp = first.stamp;
    if (!known.contains(clip.key())) others.push_back(std::move(clip));
  }
  if (others.empty()) return showRows({row});
  const auto below = project_.clips.begin() + row + 1;
  const auto added = project_.clips.insert(below, others.begin(), others.end());
  findEarlier();
  std::vector<LibraryEntry> shown;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const ProjectClip& clip = added[static_cast<std::ptrdiff_t>(i)];
    shown.push_back(entryOf(clip, {}));
    outlines_.add(clip.key());
  }
  model_->insert(row + 1, shown);
  showRows({row});
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
  return original && session_->openKey() == project_.current ? project_.find(project_.current)
                                                             : nullptr;
}

void Library::setShowsSkin(bool shows) {
  if (shows == project_.shows_skin) return;
  project_.shows_skin = shows;
  touch();
}

void Library::noteOutline(const QString& key, const ClipOutline& outline, const QString& trouble) {
  const int row = model_->rowOf(key);
  if (row < 0) return;
  LibraryEntry entry = model_->entry(row);
  entry.frames = outline.frames;
  entry.sample_rate_hz = outline.sample_rate_hz;
  entry.outline = outline.bones;
  entry.skin = outline.skin;
  entry.loop = outline.loop;
  entry.notes = outline.notes;
  entry.trouble = trouble;
  model_->setEntry(entry);
  ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  if (clip.rig.empty() && !outline.rig.empty()) readNotesOfNew(clip.path);
  if (!outline.rig.empty() && std::exchange(clip.rig, outline.rig) != outline.rig) touch();
  if (!clip.reading.take && outline.takes.keys.size() > 1) {
    noteTakes(key, outline.takes);
    touch();
    emit currentChanged();
  }
}

}  // namespace mocapress
