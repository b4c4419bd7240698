// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/review_bar.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>
#include <chrono>

#include "widgets/icons/themed_icon.h"
#include "widgets/models/library_model.h"

namespace mocapress {
namespace {

constexpr auto kCountInterval = std::chrono::milliseconds(100);

}  // namespace

ReviewBar::ReviewBar(const LibraryModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      next_(new QToolButton(this)),
      progress_(new QProgressBar(this)) {
  next_->setAutoRaise(true);
  next_->setIcon(themedIcon(QStringLiteral("frame-next")));
  next_->setToolTip(tr("Open the next clip that waits for a verdict (Q)"));
  next_->setAccessibleName(tr("Next to review"));
  progress_->setAccessibleName(tr("Clips that are reviewed"));
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(next_);
  line->addWidget(progress_, 1);
  connect(next_, &QToolButton::clicked, this, &ReviewBar::nextRequested);
  count_later_.setSingleShot(true);
  count_later_.setInterval(kCountInterval);
  connect(&count_later_, &QTimer::timeout, this, &ReviewBar::count);
  const auto count_soon = [this] {
    if (!count_later_.isActive()) count_later_.start();
  };
  connect(model, &LibraryModel::modelReset, this, count_soon);
  connect(model, &LibraryModel::rowsInserted, this, count_soon);
  connect(model, &LibraryModel::dataChanged, this, count_soon);
  count();
}

void ReviewBar::count() {
  int all = 0, reviewed = 0, rejected = 0, waiting = 0;
  for (int row = 0; row < model_->rowCount(); ++row) {
    const LibraryEntry& entry = model_->entry(row);
    if (!entry.trouble.isEmpty()) continue;  // a file that cannot be read cannot be reviewed
    ++all;
    waiting += wantsReview(entry);
    if (entry.review.verdict == Verdict::None || entry.stale != Staleness::None) continue;
    ++reviewed;
    rejected += entry.review.verdict == Verdict::Rejected;
  }
  reviewed_ = tr("%L1 of %L2 reviewed").arg(reviewed).arg(all);
  with_rejected_ = rejected == 0 ? reviewed_ : tr("%1, %L2 rejected").arg(reviewed_).arg(rejected);
  progress_->setToolTip(with_rejected_);
  showText();
  progress_->setRange(0, std::max(all, 1));
  progress_->setValue(reviewed);
  next_->setEnabled(waiting > 0);
  setVisible(all > 0);
}

/// Omits the number of rejected clips where it does not fit.
void ReviewBar::showText() {
  const bool fits = fontMetrics().horizontalAdvance(with_rejected_) < progress_->width();
  progress_->setFormat(fits ? with_rejected_ : reviewed_);
}

void ReviewBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();
  showText();
}

}  // namespace mocapress
