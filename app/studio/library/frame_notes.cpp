// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/frame_notes.h"

#include <QInputDialog>
#include <algorithm>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "widgets/timeline/note_strip.h"
#include "widgets/timeline/playback.h"

namespace mocapress {
namespace {

QString placeOf(const FrameNote& note) {
  const QString frame = FrameNotes::tr("Frame %L1").arg(note.frame + 1);
  return note.joint.empty()
             ? frame
             : FrameNotes::tr("%1, %2").arg(frame, QString::fromStdString(note.joint));
}

}  // namespace

FrameNotes::FrameNotes(Session* session, Library* library, Playback* playback, NoteStrip* strip,
                       QWidget* window)
    : QObject(window),
      session_(session),
      library_(library),
      playback_(playback),
      strip_(strip),
      window_(window) {
  connect(library, &Library::currentChanged, this, &FrameNotes::show);
  connect(&session->document(), &Document::clipChanged, this, &FrameNotes::show);
  connect(strip, &NoteStrip::seekRequested, playback, &Playback::seek);
  connect(strip, &NoteStrip::noteChosen, this, &FrameNotes::choose);
  connect(strip, &NoteStrip::editRequested, this, &FrameNotes::edit);
  connect(strip, &NoteStrip::removeRequested, library,
          [library](int index) { library->setFrameNote(library->currentRow(), index, {}); });
}

void FrameNotes::show() {
  std::vector<TimeNote> notes;
  for (const FrameNote& note : library_->frameNotes(library_->currentRow())) {
    const QString text = QString::fromStdString(note.text);
    const ClipReview by{.reviewer = note.reviewer, .time = note.time};
    notes.push_back(
        {note.frame, text,
         placeOf(note) + QLatin1Char('\n') + text + QLatin1Char('\n') + reviewerText(by)});
  }
  strip_->setNotes(std::move(notes));
}

void FrameNotes::choose(int index) {
  const std::vector<FrameNote> notes = library_->frameNotes(library_->currentRow());
  const FrameNote& note = notes.at(static_cast<std::size_t>(index));
  playback_->pause();
  playback_->seek(note.frame);
  const Skeleton* const skeleton = session_->document().skeleton();
  if (!skeleton || note.joint.empty()) return;
  if (const int joint = skeleton->find(note.joint); joint >= 0)
    session_->document().setCurrentJoint(joint);
}

void FrameNotes::showNext() {
  const std::vector<FrameNote> notes = library_->frameNotes(library_->currentRow());
  if (notes.empty()) return;
  const auto next = std::find_if(notes.begin(), notes.end(), [this](const FrameNote& note) {
    return note.frame > playback_->frame();
  });
  choose(next == notes.end() ? 0 : static_cast<int>(next - notes.begin()));
}

void FrameNotes::addHere() {
  const Document& document = session_->document();
  if (library_->currentRow() < 0 || !document.skeleton()) return;
  playback_->pause();
  FrameNote note{.frame = playback_->frame()};
  if (const int joint = document.currentJoint(); joint >= 0)
    note.joint = document.skeleton()->joint(joint).name;
  ask(note, -1);
}

void FrameNotes::edit(int index) {
  ask(library_->frameNotes(library_->currentRow()).at(static_cast<std::size_t>(index)), index);
}

void FrameNotes::ask(const FrameNote& note, int index) {
  auto* dialog = new QInputDialog(window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Note"));
  dialog->setLabelText(placeOf(note));
  dialog->setTextValue(QString::fromStdString(note.text));
  connect(dialog, &QInputDialog::textValueSelected, library_,
          [library = library_, row = library_->currentRow(), note, index](const QString& text) {
            FrameNote written = note;
            written.text = text.trimmed().toStdString();
            library->setFrameNote(row, index, written);
          });
  dialog->open();
}

}  // namespace mocapress
