// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/encoding_bar.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <chrono>

#include "widgets/icons/themed_icon.h"
#include "widgets/models/library_model.h"

namespace mocapress {
namespace {

constexpr auto kCountInterval = std::chrono::milliseconds(100);

}  // namespace

EncodingBar::EncodingBar(const LibraryModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      button_(new QToolButton(this)),
      progress_(new QProgressBar(this)) {
  button_->setCheckable(true);
  button_->setAutoRaise(true);
  progress_->setAccessibleName(tr("Clips that are compressed"));
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(button_);
  line->addWidget(progress_, 1);
  connect(button_, &QToolButton::toggled, this, [this](bool active) {
    setActive(active);
    emit activeChosen(active);
  });
  count_later_.setSingleShot(true);
  count_later_.setInterval(kCountInterval);
  connect(&count_later_, &QTimer::timeout, this, &EncodingBar::count);
  const auto count_soon = [this] {
    if (!count_later_.isActive()) count_later_.start();
  };
  connect(model, &LibraryModel::modelReset, this, count_soon);
  connect(model, &LibraryModel::rowsInserted, this, count_soon);
  connect(model, &LibraryModel::dataChanged, this, count_soon);
  setActive(false);
  count();
}

void EncodingBar::setActive(bool active) {
  const QSignalBlocker blocker(button_);
  button_->setChecked(active);
  button_->setIcon(themedIcon(active ? QStringLiteral("pause") : QStringLiteral("play")));
  button_->setToolTip(active ? tr("Pause compressing clips in the background")
                             : tr("Compress all clips in the background with their own settings, "
                                  "the open clip first."));
  button_->setAccessibleName(button_->toolTip());
}

void EncodingBar::count() {
  int all = 0, done = 0, failed = 0;
  for (int row = 0; row < model_->rowCount(); ++row) {
    const LibraryEntry& entry = model_->entry(row);
    if (entry.is_compressed || entry.missing || !entry.trouble.isEmpty()) continue;
    ++all;
    if (!entry.failure.isEmpty())
      ++failed;
    else if (entry.outcome && entry.outdated == Staleness::None)
      ++done;
  }
  const QString text = tr("%L1 of %L2 compressed").arg(done).arg(all);
  progress_->setFormat(failed == 0 ? text : tr("%1, %L2 failed").arg(text).arg(failed));
  progress_->setRange(0, std::max(all, 1));
  progress_->setValue(done + failed);
  setVisible(all > 0);
}

}  // namespace mocapress
