// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/target_control.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cassert>
#include <utility>

#include "widgets/models/log_scale.h"

namespace mocapress {
namespace {

constexpr double kFirstError = 0.5;  // cm

LogScale scaleOf(Target::Kind kind) {
  return kind == Target::Kind::Ratio ? LogScale{2, 200} : LogScale{0.05, 10};  // cm
}

}  // namespace

TargetControl::TargetControl(QWidget* parent)
    : QWidget(parent),
      other_value_(kFirstError),
      kind_(new QComboBox(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      value_(new QDoubleSpinBox(this)) {
  kind_->setAccessibleName(tr("Target"));
  kind_->addItem(tr("Compression ratio"), static_cast<int>(Target::Kind::Ratio));
  kind_->addItem(tr("Error (eps_x)"), static_cast<int>(Target::Kind::Error));
  kind_->setToolTip(
      tr("Ask for a size (compression ratio: bytes of the channels as 32-bit floats over the "
         "compressed motion bytes) or for a quality (weighted mean error eps_x)."));
  slider_->setAccessibleName(tr("Target on a slider"));
  slider_->setRange(0, LogScale().steps);
  slider_->setPageStep(50);
  slider_->setToolTip(
      tr("Drag: the standard answer follows at once, the annealed one refines it."));
  value_->setAccessibleName(tr("Target value"));
  value_->setToolTip(tr("The target as a number; type it or step through it."));
  value_->setKeyboardTracking(false);
  value_->setAlignment(Qt::AlignRight);
  value_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->addWidget(kind_, 0, 0);
  grid->addWidget(value_, 0, 1);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);

  connect(kind_, &QComboBox::activated, this, [this](int index) {
    const auto kind = static_cast<Target::Kind>(kind_->itemData(index).toInt());
    if (kind != target_.kind) choose({kind, std::exchange(other_value_, target_.value)});
  });
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    choose({target_.kind, scaleOf(target_.kind).value(position)});
  });
  connect(value_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    choose({target_.kind, value});
  });
  show();
}

void TargetControl::setTarget(const Target& target) {
  assert(target.kind == Target::Kind::Ratio || target.kind == Target::Kind::Error);
  if (target.kind != target_.kind) other_value_ = target_.value;
  target_ = target;
  show();
}

void TargetControl::choose(const Target& target) {
  target_ = target;
  show();
  emit targetChanged(target_);
}

void TargetControl::show() {
  const QSignalBlocker block_kind(kind_);
  const QSignalBlocker block_slider(slider_);
  const QSignalBlocker block_value(value_);
  const bool ratio = target_.kind == Target::Kind::Ratio;
  const LogScale scale = scaleOf(target_.kind);
  kind_->setCurrentIndex(kind_->findData(static_cast<int>(target_.kind)));
  slider_->setValue(scale.position(target_.value));
  value_->setRange(scale.lowest, scale.highest);
  value_->setDecimals(ratio ? 1 : 3);
  value_->setSuffix(ratio ? tr(" : 1") : tr(" cm"));
  value_->setValue(target_.value);
}

}  // namespace mocapress
