// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts and notes on the clips of a library.
#include <QDateTime>
#include <QDir>
#include <algorithm>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/report/verdict.h"

namespace mocapress {

namespace {

/// The reviewer's name: the user who is logged in.
std::string userName() {
  const QString home = QDir::home().dirName();
  return qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME", home)).toStdString();
}

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
  const bool is_open = session_->openKey() == clip.key();
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
    before.emplace(clip.key(), clip.review);
    after.emplace(clip.key(), reviewNow(clip, verdict));
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
  const Reviews before{{clip.key(), clip.review}}, after{{clip.key(), review}};
  history_.push(new EditStep(
      tr("Note"), [this, after] { apply(after); }, [this, before] { apply(before); },
      QStringLiteral("note ") + clip.key(), kOneNoteMs));
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
  const Reviews before{{clip.key(), clip.review}}, after{{clip.key(), review}};
  history_.push(new EditStep(
      tr("Note"), [this, after] { apply(after); }, [this, before] { apply(before); }));
}

void Library::apply(const Reviews& reviews) {
  std::vector<int> rows;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    ProjectClip& clip = project_.clips[row];
    const auto found = reviews.find(clip.key());
    if (found == reviews.end()) continue;
    clip.review = found->second;
    bindVerdict(clip);
    rows.push_back(static_cast<int>(row));
  }
  showRows(rows);
  emit currentChanged();
}

ClipReviews Library::reviews() const {
  ClipReviews all;
  for (const ProjectClip& clip : project_.clips)
    all.insert(clip.key(), {clip.review, clip.stamp.source, clip.missing});
  return all;
}

std::vector<std::string> Library::remarksOn(const QString& key) const {
  std::vector<std::string> remarks;
  for (const ProjectClip& clip : project_.clips) {
    if (clip.key() != key) continue;
    remarks = {
        verdict_text(clip.review, stale_reason(clip.review, clip.stamp.source, settingsHash(clip))),
        clip.review.note};
    for (const FrameNote& note : clip.review.notes) remarks.push_back(note_text(note));
  }
  std::erase(remarks, "");
  return remarks;
}

}  // namespace mocapress
