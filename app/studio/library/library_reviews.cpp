// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts and notes on the clips of a library.
#include <QDateTime>
#include <QDir>
#include <algorithm>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/report/verdict.h"
#include "widgets/models/report_texts.h"

namespace mocapress {

/// The reviewer's name: the user who is logged in.
std::string Library::userName() {
  const QString home = QDir::home().dirName();
  return qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME", home)).toStdString();
}

std::string Library::timeNow() {
  return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

/// Makes a review of the result in the row, by the current user and at the current time.
ClipReview Library::reviewNow(const ProjectClip& clip, Verdict verdict) const {
  ClipReview review{.verdict = verdict, .note = clip.review.note, .notes = clip.review.notes};
  if (verdict == Verdict::None) return review;
  review.reviewer = userName();
  review.time = timeNow();
  const Reviewed reviewed = reviewedOf(clip);
  review.source_hash = reviewed.source;
  review.settings_hash = reviewed.settings;
  return review;
}

Library::Reviewed Library::reviewedOf(const ProjectClip& clip) const {
  if (session_->openKey() == clip.key())
    return {session_->document().original()->stamp.source, settingsHash(clip)};
  return clip.outcome ? Reviewed{clip.outcome->source, clip.outcome->settings}
                      : Reviewed{clip.stamp.source, settingsHash(clip)};
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
    history_.push(new EditStep([] { return tr("Verdict"); }, [this, after] { apply(after); },
                               [this, before] { apply(before); }));
  if (missing == 0) return;
  emit failed(tr("No verdict for %Ln clip(s): the file is missing.", nullptr, missing));
  emit currentChanged();  // shows the old verdict again
}

void Library::setNote(int row, const QString& note) {
  if (row < 0) return;
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  ClipReview review = clip.review;
  review.note = note.toStdString();
  if (review == clip.review) return;
  const Reviews before{{clip.key(), clip.review}}, after{{clip.key(), review}};
  history_.push(new EditStep([] { return tr("Note"); }, [this, after] { apply(after); },
                             [this, before] { apply(before); },
                             QStringLiteral("note ") + clip.key(), kOneNoteMs));
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

ReviewRemarks Library::remarksOn(const QString& key) const {
  ReviewRemarks remarks;
  for (const ProjectClip& clip : project_.clips) {
    if (clip.key() != key) continue;
    const ReportLanguage say = reportLanguage();
    remarks.texts = {
        verdict_text(clip.review, stale_reason(clip.review, clip.stamp.source, settingsHash(clip)),
                     say),
        clip.review.note};
    for (const FrameNote& note : clip.review.notes)
      remarks.notes.push_back({note.frame, note_text(note, staleNote(clip, note), say)});
  }
  std::erase(remarks.texts, "");
  return remarks;
}

}  // namespace mocapress
