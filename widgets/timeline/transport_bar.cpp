// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/transport_bar.h"

#include <QAction>
#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <array>

#include "widgets/icons/themed_icon.h"
#include "widgets/timeline/playback.h"

namespace mocapress {
namespace {

constexpr int kJump = 10;  // frames
constexpr int kTakeLetters = 14;
constexpr std::array kSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

QAction* makeAction(QObject* parent, const QString& icon, const QString& text,
                    const QKeySequence& shortcut) {
  auto* action = new QAction(themedIcon(icon), text, parent);
  action->setShortcut(shortcut);
  action->setToolTip(
      QStringLiteral("%1 (%2)").arg(text, shortcut.toString(QKeySequence::NativeText)));
  return action;
}

QToolButton* makeButton(QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setAutoRaise(true);
  button->setIconSize({18, 18});
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}

QLabel* makeReadOut(const QString& name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  label->setAccessibleName(name);
  return label;
}

}  // namespace

TransportActions TransportBar::makeActions(Playback* playback, QObject* parent) {
  const auto make = [parent](const char* icon, const QString& text, const QKeySequence& shortcut) {
    return makeAction(parent, QString::fromLatin1(icon), text, shortcut);
  };
  TransportActions actions;
  actions.first = make("frame-first", tr("First Frame"), Qt::Key_Home);
  actions.previous = make("frame-previous", tr("Previous Frame"), Qt::Key_Left);
  actions.play = make("play", tr("Play or Pause"), Qt::Key_Space);
  actions.next = make("frame-next", tr("Next Frame"), Qt::Key_Right);
  actions.last = make("frame-last", tr("Last Frame"), Qt::Key_End);
  actions.loop = make("loop", tr("Loop"), Qt::CTRL | Qt::Key_L);
  actions.loop->setCheckable(true);
  actions.loop->setChecked(playback->loops());

  const auto plain = [parent](const QString& text, const QKeySequence& shortcut) {
    auto* action = new QAction(text, parent);
    action->setShortcut(shortcut);
    return action;
  };
  actions.backwards = plain(tr("Play Backwards; Press Again to Go Faster"), Qt::Key_J);
  actions.halt = plain(tr("Pause"), Qt::Key_K);
  actions.forwards = plain(tr("Play Forwards; Press Again to Go Faster"), Qt::Key_L);
  actions.ten_back = plain(tr("Ten Frames Back"), Qt::SHIFT | Qt::Key_Left);
  actions.ten_on = plain(tr("Ten Frames On"), Qt::SHIFT | Qt::Key_Right);
  actions.range_from = plain(tr("Play from Here"), Qt::Key_BracketLeft);
  actions.range_to = plain(tr("Play to Here"), Qt::Key_BracketRight);
  actions.whole_clip = plain(tr("Play the Whole Clip"), Qt::Key_Backslash);
  connect(actions.backwards, &QAction::triggered, playback, [=] { playback->shuttle(-1); });
  connect(actions.halt, &QAction::triggered, playback, &Playback::pause);
  connect(actions.forwards, &QAction::triggered, playback, [=] { playback->shuttle(1); });
  connect(actions.ten_back, &QAction::triggered, playback, [=] { playback->step(-kJump); });
  connect(actions.ten_on, &QAction::triggered, playback, [=] { playback->step(kJump); });
  connect(actions.range_from, &QAction::triggered, playback, [=] {
    const int last = playback->range() ? playback->range()->second : playback->frames() - 1;
    playback->setRange(std::pair(playback->frame(), last));
  });
  connect(actions.range_to, &QAction::triggered, playback, [=] {
    playback->setRange(
        std::pair(playback->range() ? playback->range()->first : 0, playback->frame()));
  });
  connect(actions.whole_clip, &QAction::triggered, playback,
          [=] { playback->setRange(std::nullopt); });

  connect(actions.first, &QAction::triggered, playback, [=] { playback->seek(0); });
  connect(actions.previous, &QAction::triggered, playback, [=] { playback->step(-1); });
  connect(actions.play, &QAction::triggered, playback, &Playback::toggle);
  connect(actions.next, &QAction::triggered, playback, [=] { playback->step(1); });
  connect(actions.last, &QAction::triggered, playback,
          [=] { playback->seek(playback->frames() - 1); });
  connect(actions.loop, &QAction::toggled, playback, &Playback::setLoops);
  connect(playback, &Playback::playingChanged, actions.play, [=](bool playing) {
    actions.play->setIcon(themedIcon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
  });
  return actions;
}

TransportBar::TransportBar(Playback* playback, const TransportActions& actions, QWidget* parent)
    : QWidget(parent), playback_(playback) {
  takes_ = new QComboBox(this);
  takes_->setAccessibleName(tr("Take"));
  takes_->setToolTip(tr("Animation of the file to read."));
  takes_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  takes_->setMinimumContentsLength(kTakeLetters);
  takes_->hide();
  scrub_ = new QSlider(Qt::Horizontal, this);
  scrub_->setAccessibleName(tr("Frame"));
  scrub_->setToolTip(tr("Drag to any frame."));
  time_ = makeReadOut(tr("Time"), this);
  frame_ = makeReadOut(tr("Frame read-out"), this);
  speed_ = new QComboBox(this);
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Playing speed; 1× is the recorded speed."));
  for (const double speed : kSpeeds) speed_->addItem(tr("%L1×").arg(speed), speed);
  speed_->setCurrentIndex(speed_->findData(1.0));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(4);
  row->addWidget(takes_);
  for (QAction* action :
       {actions.first, actions.previous, actions.play, actions.next, actions.last})
    row->addWidget(makeButton(action, this));
  row->addSpacing(4);
  row->addWidget(scrub_, 1);
  row->addSpacing(8);
  row->addWidget(time_);
  row->addSpacing(12);
  row->addWidget(frame_);
  row->addSpacing(8);
  row->addWidget(makeButton(actions.loop, this));
  row->addWidget(speed_);

  connect(scrub_, &QSlider::valueChanged, playback, &Playback::seek);
  connect(speed_, &QComboBox::activated, playback,
          [=, this](int index) { playback->setSpeed(speed_->itemData(index).toDouble()); });
  connect(takes_, &QComboBox::activated, this, &TransportBar::takeChosen);
  connect(playback, &Playback::clipChanged, this, &TransportBar::showClip);
  connect(playback, &Playback::frameChanged, this, &TransportBar::showFrame);
  showClip();
}

void TransportBar::setTakes(const QStringList& names, int current) {
  const QSignalBlocker blocker(takes_);
  takes_->clear();
  takes_->addItems(names);
  takes_->setCurrentIndex(current);
  takes_->setVisible(names.size() > 1);
}

void TransportBar::showClip() {
  const QSignalBlocker blocker(scrub_);
  scrub_->setRange(0, std::max(playback_->frames() - 1, 0));
  scrub_->setPageStep(std::max(playback_->frames() / 20, 1));
  setEnabled(playback_->frames() > 0);
  showFrame(playback_->frame());
}

void TransportBar::showFrame(int frame) {
  const QSignalBlocker blocker(scrub_);
  scrub_->setValue(frame);
  // Pads numbers to the width of the clip's longest, so that nothing moves during playback.
  const int frames = playback_->frames();
  const auto width = static_cast<int>(QString::number(frames).size());
  const double last_seconds = std::max(frames - 1, 0) / playback_->sampleRate();
  const auto time_width = static_cast<int>(QString::number(last_seconds, 'f', 3).size());
  time_->setText(tr("%L1 s").arg(frame / playback_->sampleRate(), time_width, 'f', 3));
  frame_->setText(tr("%L1 / %L2").arg(frames > 0 ? frame + 1 : 0, width).arg(frames));
}

}  // namespace mocapress
