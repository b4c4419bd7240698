// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/note_strip.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/models/colours.h"

namespace mocapress {
namespace {

constexpr double kNoteMark = 9;   // pixels
constexpr double kOutline = 1.5;  // pixels
constexpr double kRangeLine = 2;  // pixels
constexpr double kGap = 3;        // pixels between a mark and its text
constexpr double kReach = 7;      // pixels from a mark's middle

}  // namespace

NoteStrip::NoteStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Notes on frames"));
  setAccessibleDescription(tr("The menu Review adds a note and goes from one to the next."));
  hide();
}

void NoteStrip::setNotes(std::vector<TimeNote> notes) {
  notes_ = std::move(notes);
  setVisible(!notes_.empty());
  update();
}

void NoteStrip::setFrames(int frames) {
  frames_ = frames;
  update();
}

void NoteStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

void NoteStrip::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

void NoteStrip::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

int NoteStrip::labelWidth() const {
  return fontMetrics().horizontalAdvance(tr("Notes"));
}

TimeAxis NoteStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

void NoteStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const TimeAxis time = axis();
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(kStripMargin, 0, label_width_, height()),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("Notes"));
  const QRectF area(time.left, 1, time.right - time.left, height() - 2);
  painter.fillRect(area, palette().color(QPalette::AlternateBase));
  // The clip area is wider by half a mark, so that marks on the first and last frame are drawn
  // whole.
  painter.setClipRect(area.adjusted(-kNoteMark / 2, -1, kNoteMark / 2, 1));
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < notes_.size(); ++i) {
    const double x = time.xOf(notes_[i].frame + 0.5);
    if (const std::optional<int> last = notes_[i].last_frame) {
      const double y = area.bottom() - kRangeLine / 2;
      painter.setPen(QPen(QColor(kFrameNoteColour), kRangeLine));
      painter.drawLine(QPointF(time.xOf(notes_[i].frame), y), QPointF(time.xOf(*last + 1), y));
    }
    if (x < area.left() || x > area.right()) continue;
    const double end =
        i + 1 < notes_.size() ? time.xOf(notes_[i + 1].frame + 0.5) - kNoteMark / 2 : area.right();
    painter.setPen(QPen(QColor(kFrameNoteColour), kOutline));
    painter.setBrush(notes_[i].stale ? QBrush(Qt::NoBrush) : QBrush(QColor(kFrameNoteColour)));
    constexpr double kRadius = (kNoteMark - kOutline) / 2;
    painter.drawEllipse(QPointF(x, area.center().y()), kRadius, kRadius);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF text(x + kNoteMark / 2 + kGap, area.top(), end - x - kNoteMark / 2 - 2 * kGap,
                      area.height());
    if (text.width() > 2 * kNoteMark)
      painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                       fontMetrics().elidedText(notes_[i].text.simplified(), Qt::ElideRight,
                                                static_cast<int>(text.width())));
  }
  const double x = time.xOf(frame_ + 0.5);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

int NoteStrip::noteAt(double x) const {
  int nearest = -1;
  double least = kReach;
  for (int i = 0; i < static_cast<int>(notes_.size()); ++i) {
    const double away = std::abs(axis().xOf(notes_[static_cast<std::size_t>(i)].frame + 0.5) - x);
    if (away > least) continue;
    least = away;
    nearest = i;
  }
  return nearest;
}

bool NoteStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int note = noteAt(help->pos().x());
  QToolTip::showText(help->globalPos(),
                     note < 0
                         ? tr("A click on a mark goes to its frame and joint; the right button "
                              "edits or removes the note.")
                         : notes_[static_cast<std::size_t>(note)].details,
                     this);
  return true;
}

void NoteStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double x = event->position().x();
  if (const int note = noteAt(x); note >= 0)
    emit noteChosen(note);
  else
    emit seekRequested(axis().frameAt(x));
}

void NoteStrip::contextMenuEvent(QContextMenuEvent* event) {
  const int note = noteAt(event->pos().x());
  if (note < 0) return event->ignore();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Edit Note…"), this, [=, this] { emit editRequested(note); });
  menu->addAction(tr("Remove Note"), this, [=, this] { emit removeRequested(note); });
  menu->addSeparator();
  menu->addActions(actions());
  menu->popup(event->globalPos());
}

}  // namespace mocapress
