// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/timeline/byte_strip.h"
#include "widgets/timeline/contact_strip.h"
#include "widgets/timeline/error_strip.h"
#include "widgets/timeline/note_strip.h"
#include "widgets/timeline/pose_strip.h"
#include "widgets/timeline/sight_strip.h"
#include "widgets/timeline/time_ruler.h"

namespace mocapress {
namespace {

constexpr double kNotch = 120;           // Qt's angle delta of a wheel notch
constexpr double kLengthPerNotch = 0.8;  // factor on the visible length per notch
constexpr double kMovePerNotch = 0.15;   // distance moved per notch, as share of the visible length
constexpr double kLeastFrames = 12;      // smallest visible length
constexpr double kLead = 0.05;           // share of the visible length before an entering playhead

double possibleLength(double wanted, int frames) {
  const double all = std::max(frames, 1);
  return std::clamp(wanted, std::min(kLeastFrames, all), all);
}

}  // namespace

Timeline::Timeline(QWidget* parent)
    : QWidget(parent),
      ruler_(new TimeRuler(this)),
      errors_(new ErrorStrip(this)),
      sight_(new SightStrip(this)),
      bytes_(new ByteStrip(this)),
      notes_(new NoteStrip(this)),
      contacts_(new ContactStrip(this)),
      poses_(new PoseStrip(this)),
      scroll_(new QScrollBar(Qt::Horizontal, this)) {
  scroll_->setAccessibleName(tr("Visible part of the clip"));
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 2, 0, 0);
  column->setSpacing(0);
  column->addWidget(ruler_);
  column->addWidget(poses_);
  column->addWidget(errors_);
  column->addWidget(sight_);
  column->addWidget(bytes_);
  column->addWidget(notes_);
  column->addWidget(contacts_);
  column->addWidget(scroll_);
  connect(ruler_, &TimeRuler::seekRequested, this, &Timeline::seekRequested);
  connect(errors_, &ErrorStrip::seekRequested, this, &Timeline::seekRequested);
  connect(contacts_, &ContactStrip::seekRequested, this, &Timeline::seekRequested);
  connect(poses_, &PoseStrip::seekRequested, this, &Timeline::seekRequested);
  connect(scroll_, &QScrollBar::valueChanged, this,
          [this](int first) { setWindow(first, window_.length); });
  offerFold(poses_, QStringLiteral("poses"), tr("&Poses"));
  offerFold(errors_, QStringLiteral("errors"), tr("&Errors"));
  offerFold(sight_, QStringLiteral("sight"), tr("Visible E&rrors"));
  offerFold(bytes_, QStringLiteral("bytes"), tr("&Bytes"));
  offerFold(notes_, QStringLiteral("notes"), tr("&Notes"));
  offerFold(contacts_, QStringLiteral("contacts"), tr("&Contacts"));
  setContacts({}, {}, 0);  // reserves room for names
}

/// Folding sets the height to 0, since hiding is taken: strips hide themselves when they are empty.
void Timeline::offerFold(QWidget* strip, const QString& id, const QString& name) {
  auto* action = new QAction(name, this);
  action->setObjectName(QStringLiteral("timeline-") + id);
  action->setCheckable(true);
  connect(action, &QAction::toggled, strip,
          [strip](bool unfolded) { strip->setMaximumHeight(unfolded ? QWIDGETSIZE_MAX : 0); });
  const QString setting = QStringLiteral("timeline/") + id;
  action->setChecked(true);
  action->setChecked(QSettings().value(setting, true).toBool());
  connect(action, &QAction::triggered, this,
          [setting](bool unfolded) { QSettings().setValue(setting, unfolded); });
  folds_ << action;
}

/// The menu of all strips without one of their own, and of the names: the actions of the ruler, and
/// the choice of the strips that are shown.
void Timeline::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addActions(ruler_->actions());
  menu->addSeparator();
  menu->addActions(folds_);
  menu->popup(event->globalPos());
}

void Timeline::addRangeActions(const QList<QAction*>& actions) {
  for (QWidget* strip : std::initializer_list<QWidget*>{ruler_, notes_, contacts_})
    strip->addActions(actions);
}

int Timeline::labelWidth() const {
  return std::max({ruler_->labelWidth(), errors_->labelWidth(), sight_->labelWidth(),
                   bytes_->labelWidth(), notes_->labelWidth(), contacts_->labelWidth(),
                   poses_->labelWidth()});
}

void Timeline::setRate(double sample_rate_hz) {
  sample_rate_hz_ = sample_rate_hz;
  ruler_->setClip(frames_, sample_rate_hz_);
}

void Timeline::setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                           int frames) {
  contacts_->setContacts(std::move(contacts), names, frames);
  const int width = labelWidth();
  ruler_->setLabelWidth(width);
  errors_->setLabelWidth(width);
  sight_->setLabelWidth(width);
  bytes_->setLabelWidth(width);
  notes_->setLabelWidth(width);
  notes_->setFrames(frames);
  contacts_->setLabelWidth(width);
  poses_->setLabelWidth(width);
  if (frames == frames_) return;
  frames_ = frames;
  ruler_->setClip(frames_, sample_rate_hz_);
  showAll();
}

void Timeline::setFrame(int frame) {
  ruler_->setFrame(frame);
  errors_->setFrame(frame);
  sight_->setFrame(frame);
  bytes_->setFrame(frame);
  notes_->setFrame(frame);
  contacts_->setFrame(frame);
  poses_->setFrame(frame);
  if (window_.length == 0) return;
  if (frame < window_.first)
    setWindow(frame + 1 - (1 - kLead) * window_.length, window_.length);
  else if (frame + 1 > window_.first + window_.length)
    setWindow(frame - kLead * window_.length, window_.length);
}

void Timeline::showAll() {
  setWindow(0, frames_);
}

void Timeline::showRange(const FrameRange& range) {
  const double wanted = range.second - range.first + 1;
  const double length = possibleLength(wanted, frames_);
  setWindow(range.first - (length - wanted) / 2, length);
}

TimeAxis Timeline::axis() const {
  return {static_cast<double>(2 * kStripMargin + labelWidth()),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

void Timeline::setWindow(double first, double length) {
  length = possibleLength(length, frames_);
  const bool whole = length >= frames_;
  window_ = whole ? FrameWindow() : FrameWindow{std::clamp(first, 0.0, frames_ - length), length};
  ruler_->setWindow(window_);
  errors_->setWindow(window_);
  sight_->setWindow(window_);
  bytes_->setWindow(window_);
  notes_->setWindow(window_);
  contacts_->setWindow(window_);
  poses_->setWindow(window_);
  const QSignalBlocker blocker(scroll_);
  scroll_->setRange(0, whole ? 0 : static_cast<int>(std::ceil(frames_ - length)));
  scroll_->setPageStep(static_cast<int>(length));
  scroll_->setSingleStep(std::max(1, static_cast<int>(kMovePerNotch * length)));
  scroll_->setValue(static_cast<int>(std::lround(window_.first)));
  scroll_->setVisible(!whole);
}

void Timeline::wheelEvent(QWheelEvent* event) {
  const QPointF turned = QPointF(event->angleDelta()) / kNotch;
  const bool sideways = std::abs(turned.x()) > std::abs(turned.y());
  const TimeAxis time = axis();
  event->accept();
  if (sideways || (event->modifiers() & Qt::ShiftModifier)) {
    const double notches = sideways ? turned.x() : turned.y();
    return setWindow(window_.first - notches * kMovePerNotch * time.length(), time.length());
  }
  // The frame under the mouse stays under the mouse.
  const double share =
      std::clamp((event->position().x() - time.left) / (time.right - time.left), 0.0, 1.0);
  const double length =
      possibleLength(time.length() * std::pow(kLengthPerNotch, turned.y()), frames_);
  setWindow(window_.first + share * (time.length() - length), length);
}

}  // namespace mocapress
