// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/message_bar.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStyle>
#include <QToolButton>
#include <chrono>

#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

constexpr auto kNoteStays = std::chrono::seconds(8);
constexpr QRgb kErrorColour = 0xffd55e00;
constexpr QRgb kNoteColour = 0xff0072b2;

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      text_(new QLabel(this)),
      work_(new QProgressBar(this)),
      remedy_(new QToolButton(this)) {
  setAccessibleName(tr("Message"));
  setAutoFillBackground(true);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setMinimumWidth(1);  // a long word must not widen the window
  auto* close = new QToolButton(this);
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setAccessibleName(tr("Close message"));
  close->setToolTip(tr("Close"));

  remedy_->setAccessibleName(tr("Possible solution"));
  work_->setAccessibleName(tr("Work in progress"));
  work_->setRange(0, 0);  // a busy indicator: the duration is unknown
  work_->setTextVisible(false);
  work_->setMaximumSize(160, 8);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 6, 6);
  row->addWidget(text_, 1);
  row->addWidget(work_);
  row->addWidget(remedy_);
  row->addWidget(close, 0, Qt::AlignTop);

  leave_.setSingleShot(true);
  leave_.setInterval(kNoteStays);
  connect(&leave_, &QTimer::timeout, this, &QWidget::hide);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  connect(remedy_, &QToolButton::triggered, this, &QWidget::hide);
  hide();
}

void MessageBar::showNote(const QString& text) {
  showText(text, false, nullptr);
  leave_.start();
}

void MessageBar::showWork(const QString& text) {
  showText(text, false, nullptr);
  work_->show();
}

void MessageBar::showError(const QString& text, QAction* remedy) {
  showText(text, true, remedy);
}

QString MessageBar::text() const {
  return text_->text();
}

void MessageBar::showText(const QString& text, bool error, QAction* remedy) {
  leave_.stop();
  error_ = error;
  const QString shown = translatedSentence(text);
  text_->setText(shown);
  text_->setToolTip(shown);
  work_->hide();
  remedy_->setDefaultAction(remedy);
  remedy_->setVisible(remedy != nullptr);
  applyColours();
  show();
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  // Only the application's palette matters: applyColours() itself changes this widget's palette.
  if (event->type() == QEvent::ApplicationPaletteChange) applyColours();
}

void MessageBar::applyColours() {
  const QPalette outer = parentWidget() ? parentWidget()->palette() : QPalette();
  const QColor colour(error_ ? kErrorColour : kNoteColour);
  const QColor base = outer.color(QPalette::Window);
  constexpr float kTint = 0.22F;
  const auto mix = [](float a, float b) { return a + kTint * (b - a); };
  QPalette own = outer;
  own.setColor(QPalette::Window, QColor::fromRgbF(mix(base.redF(), colour.redF()),
                                                  mix(base.greenF(), colour.greenF()),
                                                  mix(base.blueF(), colour.blueF())));
  setPalette(own);
}

}  // namespace mocapress
