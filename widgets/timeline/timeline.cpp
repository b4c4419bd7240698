// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline.h"

#include <QVBoxLayout>
#include <algorithm>

#include "widgets/timeline/contact_strip.h"
#include "widgets/timeline/error_strip.h"

namespace mocapress {

Timeline::Timeline(QWidget* parent)
    : QWidget(parent), errors_(new ErrorStrip(this)), contacts_(new ContactStrip(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 2, 0, 0);
  column->setSpacing(0);
  column->addWidget(errors_);
  column->addWidget(contacts_);
  connect(errors_, &ErrorStrip::seekRequested, this, &Timeline::seekRequested);
  connect(contacts_, &ContactStrip::seekRequested, this, &Timeline::seekRequested);
  errors_->setLabelWidth(errors_->labelWidth());
}

void Timeline::setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                           int frames) {
  contacts_->setContacts(std::move(contacts), names, frames);
  const int width = std::max(errors_->labelWidth(), contacts_->labelWidth());
  errors_->setLabelWidth(width);
  contacts_->setLabelWidth(width);
}

void Timeline::setFrame(int frame) {
  errors_->setFrame(frame);
  contacts_->setFrame(frame);
}

}  // namespace mocapress
