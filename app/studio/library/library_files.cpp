// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a library's clips: changed, missing, found elsewhere.
#include <QFileInfo>
#include <QHash>
#include <utility>

#include "app/jobs/open_clip.h"
#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"

namespace mocapress {

void Library::checkFiles() {
  check_again_ = checking_.busy();
  if (check_again_ || project_.clips.empty()) return;
  std::vector<ClipSource> sources;
  std::vector<QString> keys;
  for (const ProjectClip& clip : project_.clips) {
    sources.push_back({clip.path, clip.skeleton, clip.stamp});
    keys.push_back(clip.key());
  }
  checking_.start([sources](const Job& job) { return lookAt(sources, job); },
                  [this, keys, sources](const std::vector<SourceNow>& now) {
                    noteFiles(keys, sources, now);
                    emit looked();
                    if (check_again_) checkFiles();
                  },
                  [this](const QString& message) { emit failed(message); });
}

void Library::noteFiles(const std::vector<QString>& keys, const std::vector<ClipSource>& sources,
                        const std::vector<SourceNow>& now) {
  const QHash<QString, int> rows = project_.rows();
  std::vector<int> others;
  int changed = 0, missing = 0;
  bool any_new = false;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const int row = rows.value(keys[i], -1);
    if (row < 0) continue;
    ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
    if (clip.stamp.hash != sources[i].stamp.hash) continue;  // opened since, so its stamp is newer
    const bool was_missing = std::exchange(clip.missing, now[i].state == SourceNow::State::Missing);
    const bool is_new = now[i].state == SourceNow::State::Found &&
                        (was_missing || now[i].stamp.hash != clip.stamp.hash);
    const bool was_looked_at = !clip.stamp.hash.empty();
    // The first look at a clip that was only added changes nothing in its row.
    const bool is_only_added =
        !was_looked_at && !clip.outcome && clip.failure.isEmpty() && clip.review == ClipReview();
    if (is_new && (was_missing || was_looked_at)) outlines_.add(clip.key());
    if (is_new && !was_missing && was_looked_at) ++changed;
    if (clip.missing && !was_missing) ++missing;
    if (now[i].state == SourceNow::State::Found) clip.stamp = now[i].stamp;
    if (is_new) clip.failure.clear();
    bindVerdict(clip);
    if ((is_new && !is_only_added) || clip.missing != was_missing) others.push_back(row);
    any_new = any_new || is_new;
  }
  if (any_new) touch();
  showRows(others);
  if (!others.empty()) emit currentChanged();
  if (changed > 0) emit noted(tr("The files of %Ln clip(s) have changed.", nullptr, changed));
  if (missing > 0)
    emit noted(
        tr("The files of %Ln clip(s) are missing. The library's context menu finds them in "
           "another folder.",
           nullptr, missing));
  openIfChanged();
}

/// Opens the current clip again if its file has changed, once for each content: a file that cannot
/// be read, or takes longer than the time between two checks, is not opened over and over.
void Library::openIfChanged() {
  const ProjectClip* open = openNow();
  if (!open || open->missing || session_->isOpening()) return;
  const std::string& hash = open->stamp.hash;
  if (hash == session_->document().original()->stamp.hash || hash == tried_) return;
  tried_ = hash;
  session_->open(open->path, open->skeleton, open->reading);
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
        std::erase_if(moved, [this](const auto& one) {
          return !project_.findFile(one.first) || project_.findFile(one.second.path);
        });
        int found_again = 0;  // counts takes, of which a file may have several
        std::map<QString, ClipSource> back;
        for (const ClipSource& clip : missing)
          if (const auto found = moved.find(clip.path); found != moved.end()) {
            back.emplace(found->second.path, clip);
            ++found_again;
          }
        const int left = static_cast<int>(missing.size()) - found_again;
        if (!moved.empty())
          history_.push(new EditStep([] { return tr("Find Clips"); },
                                     [this, moved] { move(moved); }, [this, back] { move(back); }));
        emit noted(tr("Found %Ln clip(s)", nullptr, found_again) +
                   (left > 0 ? tr(", %Ln still missing", nullptr, left) : QString()));
      },
      [this](const QString& message) { emit failed(message); });
}

/// Gives clips the new paths of their files; everything else stays.
void Library::move(const std::map<QString, ClipSource>& to) {
  std::vector<LibraryEntry> all = entries();
  bool current_moves = false;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    ProjectClip& clip = project_.clips[row];
    const auto found = to.find(clip.path);
    if (found == to.end()) continue;
    const bool is_current = clip.key() == project_.current;
    clip.path = found->second.path;
    if (is_current) project_.current = clip.key();
    current_moves = current_moves || is_current;
    clip.skeleton = found->second.skeleton;
    clip.stamp = found->second.stamp;
    clip.missing = false;
    all[row] = entryOf(clip, all[row]);
    all[row].trouble.clear();
    outlines_.add(clip.key());
  }
  model_->setEntries(std::move(all));
  checkFiles();
  touch();
  emit currentChanged();
  if (current_moves) openClip(currentRow());
}

/// Notes the failure and closes the clip that was open, which would otherwise seem to be the chosen
/// one.
void Library::noteOpenFailed(const OpenRequest& request, const QString& message) {
  const QString key = clipKey(request.path, request.reading.value_or(ReadOptions()).take);
  const int row = model_->rowOf(key);
  if (row < 0 || request.compare) return;
  ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  clip.missing = !QFileInfo::exists(clip.path);
  if (session_->openKey() != key) {
    session_->closeClip();
    project_.current = key;
  }
  LibraryEntry entry = entryOf(clip, model_->entry(row));
  entry.trouble = message;
  model_->setEntry(entry);
  touch();
  emit currentChanged();
}

}  // namespace mocapress
