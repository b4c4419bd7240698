// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on frames of the clips of a library, and the files beside the clips that carry them.
#include <algorithm>
#include <utility>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/base/error.h"
#include "core/report/notes_file.h"

namespace mocapress {

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
    const Reviewed reviewed = reviewedOf(clip);
    written.source_hash = reviewed.source;
    written.settings_hash = reviewed.settings;
    const auto place =
        std::upper_bound(review.notes.begin(), review.notes.end(), written,
                         [](const FrameNote& a, const FrameNote& b) { return a.frame < b.frame; });
    review.notes.insert(place, written);
  }
  if (review == clip.review) return;
  const Reviews before{{clip.key(), clip.review}}, after{{clip.key(), review}};
  history_.push(new EditStep([] { return tr("Note"); }, [this, after] { apply(after); },
                             [this, before] { apply(before); }));
}

namespace {

std::string takeKey(const ProjectClip& clip) {
  return clip.reading.take.value_or(std::string());
}

struct NotesBeside {
  std::map<QString, NotesByTake> found;
  QString trouble;  // with the last file that cannot be read; the others are read all the same
};

NotesBeside notesBeside(const std::vector<QString>& paths, const Job& job) {
  NotesBeside beside;
  for (const QString& path : paths) {
    if (job.stopRequested()) break;
    try {
      NotesByTake notes = read_notes(path.toStdU16String());
      if (!notes.empty()) beside.found.emplace(path, std::move(notes));
    } catch (const Error& error) {
      beside.trouble = QString::fromStdString(error.what());
    }
  }
  return beside;
}

}  // namespace

/// Other people's notes stay in the files even if the library lacks them. The user's own notes in a
/// file are replaced by those in the library.
void Library::writeNotes() {
  std::map<QString, NotesByTake> by_file;
  for (const ProjectClip& clip : project_.clips)
    if (!clip.missing && (clip.notes_beside || !clip.review.notes.empty()))
      by_file[clip.path][takeKey(clip)] = clip.review.notes;
  if (by_file.empty()) return emit noted(tr("No clip has notes on its frames."));
  carrying_notes_.start(
      [by_file = std::move(by_file), me = userName()](const Job& job) {
        NotesByFile written;
        for (auto [path, notes] : by_file) {
          if (job.stopRequested()) break;
          for (auto& [take, there] : read_notes(path.toStdU16String())) {
            if (notes.contains(take))  // else the library lacks the take
              std::erase_if(there, [&me](const FrameNote& note) { return note.reviewer == me; });
            add_notes(notes[take], there);
          }
          write_notes(path.toStdU16String(), notes);
          written.emplace(path, by_file.at(path));
        }
        return written;
      },
      [this](const NotesByFile& written) {
        noteBeside(written);
        emit noted(tr("Wrote the notes of %Ln file(s) beside them.", nullptr,
                      static_cast<int>(written.size())));
      },
      [this](const QString& message) { emit failed(message); });
}

void Library::readNotes() {
  std::vector<QString> paths;
  for (const ProjectClip& clip : project_.clips)
    if (!clip.missing && (paths.empty() || paths.back() != clip.path)) paths.push_back(clip.path);
  carrying_notes_.start(
      [paths = std::move(paths)](const Job& job) { return notesBeside(paths, job); },
      [this](const NotesBeside& beside) {
        noteBeside(beside.found);
        const auto [before, after, added] = withNotes(beside.found);
        if (!after.empty())
          history_.push(new EditStep([] { return tr("Read Notes"); },
                                     [this, after = after] { apply(after); },
                                     [this, before = before] { apply(before); }));
        emit noted(added > 0 ? tr("Read %Ln note(s).", nullptr, added)
                             : tr("The files beside the clips have no other notes."));
        if (!beside.trouble.isEmpty()) emit failed(beside.trouble);
      },
      [this](const QString& message) { emit failed(message); });
}

/// Notes of new clips are read at once, and not as a step of history().
void Library::readNotesOfNew(const QString& path) {
  new_.push_back(path);
  readNewNotes();
}

/// Reads the notes of all new files, unless such a reading is under way.
void Library::readNewNotes() {
  if (reading_new_notes_.busy() || new_.empty()) return;
  reading_new_notes_.start(
      [paths = std::exchange(new_, {})](const Job& job) { return notesBeside(paths, job); },
      [this](const NotesBeside& beside) {
        noteBeside(beside.found);
        if (const auto more = withNotes(beside.found); !more.after.empty()) apply(more.after);
        if (!beside.trouble.isEmpty()) emit failed(beside.trouble);
        readNewNotes();
      },
      [this](const QString& message) {
        emit failed(message);
        readNewNotes();
      });
}

/// Remembers which clips have notes in the files that were read or written.
void Library::noteBeside(const NotesByFile& files) {
  if (files.empty()) return;
  for (ProjectClip& clip : project_.clips)
    if (const auto file = files.find(clip.path); file != files.end())
      if (const auto take = file->second.find(takeKey(clip)); take != file->second.end())
        clip.notes_beside = !take->second.empty();
  touch();
}

Library::MoreNotes Library::withNotes(const NotesByFile& found) const {
  MoreNotes more;
  if (found.empty()) return more;
  for (const ProjectClip& clip : project_.clips) {
    const auto file = found.find(clip.path);
    if (file == found.end()) continue;
    const auto take = file->second.find(takeKey(clip));
    if (take == file->second.end()) continue;
    ClipReview review = clip.review;
    add_notes(review.notes, take->second);
    if (review == clip.review) continue;
    more.added += static_cast<int>(review.notes.size() - clip.review.notes.size());
    more.before.emplace(clip.key(), clip.review);
    more.after.emplace(clip.key(), std::move(review));
  }
  return more;
}

}  // namespace mocapress
