// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/slot_control.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace mocapress {
namespace {

const std::array<QString, 2> kNames = {QStringLiteral("A"), QStringLiteral("B")};

const QString kWidestSlot = QStringLiteral("A   199.9 : 1, 0.0 mm");

}  // namespace

SlotControl::SlotControl(QWidget* parent) : QWidget(parent), copy_(new QToolButton(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i] = new QToolButton(this);
    buttons_[i]->setCheckable(true);
    buttons_[i]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    // The minimum width fits the longest summary, so that nothing moves when the numbers arrive.
    buttons_[i]->setMinimumWidth(fontMetrics().horizontalAdvance(kWidestSlot) + 12);
    buttons_[i]->setAccessibleName(tr("Settings %1").arg(kNames[i]));
    buttons_[i]->setToolTip(
        tr("Two settings to compare: tune one, switch to the other (A), and compare the results."));
    row->addWidget(buttons_[i], 1);
    connect(buttons_[i], &QToolButton::clicked, this, [this, i] {
      buttons_[static_cast<std::size_t>(active_)]->setChecked(true);
      if (static_cast<int>(i) == active_) return;
      buttons_[i]->setChecked(false);  // stays off until setSlots()
      emit switchRequested();
    });
  }
  copy_->setAccessibleName(tr("Copy settings to the other"));
  row->addWidget(copy_);
  connect(copy_, &QToolButton::clicked, this, &SlotControl::copyRequested);
  setSlots(0, {});
}

void SlotControl::setSlots(int active, const std::array<QString, 2>& summaries) {
  active_ = active;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->setChecked(static_cast<int>(i) == active);
    buttons_[i]->setText(summaries[i].isEmpty() ? kNames[i]
                                                : tr("%1   %2").arg(kNames[i], summaries[i]));
  }
  const QString to = kNames[static_cast<std::size_t>(1 - active)];
  copy_->setText(tr("→ %1").arg(to));
  copy_->setToolTip(tr("Copy these settings to %1").arg(to));
}

}  // namespace mocapress
