// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/warnings_panel.h"

#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/models/sentence.h"
#include "widgets/panels/elided_label.h"

namespace mocapress {
namespace {

constexpr int kListHeight = 110;

/// The warning without the path of the clip, which the user sees already.
QString noteText(const QString& clip, const Warning& warning) {
  if (QString::fromStdString(warning.file) != clip)
    return translatedSentence(QString::fromStdString(warning.text()));
  const QString message = translatedSentence(QString::fromStdString(warning.message));
  return warning.line > 0 ? WarningsPanel::tr("line %L1: %2").arg(warning.line).arg(message)
                          : message;
}

}  // namespace

WarningsPanel::WarningsPanel(QWidget* parent)
    : QFrame(parent),
      title_(new ElidedLabel(this)),
      unfold_(new QToolButton(this)),
      list_(new QPlainTextEdit(this)) {
  setAccessibleName(tr("Notes on reading"));
  unfold_->setCheckable(true);
  unfold_->setAutoRaise(true);
  unfold_->setArrowType(Qt::RightArrow);
  unfold_->setAccessibleName(tr("Show notes"));
  unfold_->setToolTip(tr("Show what was repaired or guessed while reading"));
  auto* dismiss = new QToolButton(this);
  dismiss->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  dismiss->setAutoRaise(true);
  dismiss->setAccessibleName(tr("Dismiss notes"));
  dismiss->setToolTip(tr("Dismiss"));
  list_->setReadOnly(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFixedHeight(kListHeight);
  list_->setAccessibleName(tr("Notes"));

  auto* row = new QHBoxLayout;
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(unfold_);
  row->addWidget(title_, 1);
  row->addWidget(dismiss);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(row);
  column->addWidget(list_);

  connect(unfold_, &QToolButton::toggled, this, [this](bool on) {
    unfold_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    list_->setVisible(on);
  });
  connect(dismiss, &QToolButton::clicked, this, &QWidget::hide);
  list_->hide();
  hide();
}

void WarningsPanel::setWarnings(const QString& clip, const Warnings& warnings) {
  QStringList lines;
  for (const Warning& warning : warnings) lines << noteText(clip, warning);
  const bool is_told = std::exchange(told_[clip], lines) == lines;
  if (std::exchange(clip_, clip) == clip && is_told) return;
  list_->setPlainText(lines.join(QLatin1Char('\n')));
  // A single note is the title itself.
  title_->setText(lines.size() == 1 ? lines.front()
                                    : tr("%n note(s) on reading this clip", nullptr,
                                         static_cast<int>(lines.size())));
  unfold_->setVisible(lines.size() > 1);
  unfold_->setChecked(false);
  setVisible(!lines.isEmpty() && !is_told);
}

}  // namespace mocapress
