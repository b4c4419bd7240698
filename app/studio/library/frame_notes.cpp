// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/frame_notes.h"

#include <QDateTime>
#include <QInputDialog>
#include <QLocale>
#include <algorithm>
#include <array>
#include <optional>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "widgets/timeline/note_strip.h"
#include "widgets/timeline/playback.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr int kNoteWidth = 420;  // px, width of a sentence

QString placeOf(const FrameNote& note) {
  const QString frame =
      note.last_frame
          ? FrameNotes::tr("Frames %L1–%L2").arg(note.frame + 1).arg(*note.last_frame + 1)
          : FrameNotes::tr("Frame %L1").arg(note.frame + 1);
  return note.joint.empty()
             ? frame
             : FrameNotes::tr("%1, %2").arg(frame, QString::fromStdString(note.joint));
}

/// "ana, 28.11.26 10:00"; empty: unknown.
QString writerOf(const FrameNote& note) {
  const QDateTime time = QDateTime::fromString(QString::fromStdString(note.time), Qt::ISODate);
  QStringList parts{QString::fromStdString(note.reviewer)};
  if (time.isValid()) parts << QLocale().toString(time.toLocalTime(), QLocale::ShortFormat);
  parts.removeAll(QString());
  return parts.join(FrameNotes::tr(", "));
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

void FrameNotes::showIn(Viewport* viewport) {
  viewport_ = viewport;
  connect(viewport, &Viewport::placePointed, this, &FrameNotes::addAt);
  show();
}

void FrameNotes::show() {
  const int row = library_->currentRow();
  std::vector<TimeNote> notes;
  std::vector<PlacedNote> placed;
  const Skeleton* const skeleton = session_->document().skeleton();
  for (const FrameNote& note : library_->frameNotes(row)) {
    const ProjectClip& clip = library_->project().clips[static_cast<std::size_t>(row)];
    const QString text = QString::fromStdString(note.text);
    QStringList lines{placeOf(note), text, writerOf(note)};
    const std::optional<std::string> stale = staleNote(clip, note);
    if (stale) lines << tr("Stale: the clip's file or settings have changed since.");
    lines.removeAll(QString());
    notes.push_back(
        {note.frame, text, lines.join(QLatin1Char('\n')), stale.has_value(), note.last_frame});
    const int joint = skeleton ? skeleton->find(note.joint) : -1;
    PlacedNote in_picture{.frame = note.frame,
                          .last_frame = note.last_frame.value_or(note.frame),
                          .joint = joint,
                          .text = text};
    if (const auto& place = note.place_cm)
      in_picture.place_cm =
          QVector3D(static_cast<float>((*place)[0]), static_cast<float>((*place)[1]),
                    static_cast<float>((*place)[2]));
    if (joint >= 0 || in_picture.place_cm) placed.push_back(in_picture);
  }
  strip_->setNotes(std::move(notes));
  if (viewport_) viewport_->setNotes(std::move(placed));
}

void FrameNotes::choose(int index) {
  const std::vector<FrameNote> notes = library_->frameNotes(library_->currentRow());
  const FrameNote& note = notes.at(static_cast<std::size_t>(index));
  playback_->pause();
  playback_->seek(note.frame);
  if (note.last_frame) playback_->setRange(std::pair(note.frame, *note.last_frame));
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
  add({.frame = playback_->frame()});
}

void FrameNotes::addOnRange() {
  if (const auto range = playback_->range())
    add({.frame = range->first, .last_frame = range->second});
}

void FrameNotes::add(FrameNote note) {
  const Document& document = session_->document();
  if (library_->currentRow() < 0 || !document.skeleton()) return;
  playback_->pause();
  if (const int joint = document.currentJoint(); joint >= 0)
    note.joint = document.skeleton()->joint(joint).name;
  ask(note, -1);
}

void FrameNotes::addAt(int joint, const QVector3D& place_cm) {
  const Document& document = session_->document();
  if (library_->currentRow() < 0 || !document.skeleton()) return;
  playback_->pause();
  FrameNote note{.frame = playback_->frame()};
  if (joint >= 0)
    note.joint = document.skeleton()->joint(joint).name;
  else
    note.place_cm = std::array<double, 3>{place_cm.x(), place_cm.y(), place_cm.z()};
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
          [library = library_, key = library_->project().current, note,
           is_new = index < 0](const QString& text) {
            FrameNote written = note;
            written.text = text.trimmed().toStdString();
            // Clip and note may have moved meanwhile. If the note is gone or was changed by others,
            // the text becomes a new note.
            const int row = library->project().rows().value(key, -1);
            const std::vector<FrameNote> notes = library->frameNotes(row);
            const auto found = is_new ? notes.end() : std::find(notes.begin(), notes.end(), note);
            library->setFrameNote(
                row, found == notes.end() ? -1 : static_cast<int>(found - notes.begin()), written);
          });
  dialog->resize(kNoteWidth, dialog->sizeHint().height());
  dialog->open();
}

}  // namespace mocapress
