// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/factor_control.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

namespace mocapress {
namespace {

constexpr double kMost = 1000;
constexpr double kSnap = 0.06;  // difference of logarithms within which the slider snaps to 1

}  // namespace

FactorControl::FactorControl(const QString& name, const QString& tip, const LogScale& scale,
                             bool from_none, QWidget* parent)
    : QWidget(parent),
      scale_(scale),
      from_none_(from_none),
      value_(from_none ? 0 : 1),
      slider_(new QSlider(Qt::Horizontal, this)),
      number_(new QDoubleSpinBox(this)) {
  slider_->setAccessibleName(tr("%1 on a slider").arg(name));
  slider_->setToolTip(tip);
  slider_->setRange(0, scale.steps);
  slider_->setPageStep(50);
  number_->setAccessibleName(name);
  number_->setToolTip(tip);
  number_->setRange(0, kMost);
  number_->setDecimals(2);
  number_->setPrefix(QStringLiteral("× "));
  number_->setAlignment(Qt::AlignRight);
  number_->setKeyboardTracking(false);
  number_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  if (from_none) number_->setSpecialValueText(tr("none"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(number_);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) { choose(at(position)); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, &FactorControl::choose);
  setValue(value_);
}

double FactorControl::at(int position) const {
  if (from_none_ && position == 0) return 0;
  const double value = scale_.value(position);
  if (!from_none_ && std::abs(std::log(value)) < kSnap) return 1;
  return std::round(100 * value) / 100;
}

void FactorControl::setValue(double value) {
  value_ = value;
  const QSignalBlocker block_slider(slider_);
  const QSignalBlocker block_number(number_);
  slider_->setValue(value > 0 ? scale_.position(value) : 0);
  number_->setValue(value);
}

void FactorControl::choose(double value) {
  if (value == value_) return;
  setValue(value);
  emit valueChanged(value);
}

}  // namespace mocapress
