// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/target_control.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cassert>
#include <cmath>

#include "widgets/models/log_scale.h"
#include "widgets/models/sentence.h"
#include "widgets/panels/number_fields.h"

namespace mocapress {
namespace {

/// The display of a kind of target, and its initial value.
struct Unit {
  LogScale scale;
  double first;
  int shown_decimals;
  int most_decimals;
  QString suffix;
  double shown_as_one = 1;  // the target's value that is shown as 1

  double shown(double value) const { return value / shown_as_one; }

  /// Converts a shown number to the target's value. Removes the rounding error of the product, so
  /// that 6.6 mm are 0.66 cm, as on the command line.
  double value(double shown) const {
    constexpr double kFinest = 1e9;
    return shown_as_one == 1 ? shown : std::round(shown * shown_as_one * kFinest) / kFinest;
  }
};

constexpr double kMillimetre = 0.1;  // cm

Unit unitOf(Target::Kind kind) {
  switch (kind) {
    case Target::Kind::Size:
      return {{100, 1e7}, 10e3, 0, 0, TargetControl::tr(" bytes")};
    case Target::Kind::Error:
      return {{0.01, 10}, 0.5, 1, 6, TargetControl::tr(" mm"), kMillimetre};
    case Target::Kind::MaxError:
      return {{0.05, 20}, 2, 1, 6, TargetControl::tr(" mm"), kMillimetre};
    case Target::Kind::Visibility:
      return {{0.2, 20}, 1, 1, 6, TargetControl::tr(" times")};
    case Target::Kind::Ratio:
    case Target::Kind::CoefficientRatio:
      break;
  }
  return {{2, 1000}, 25, 1, 3, TargetControl::tr(" : 1")};
}

/// Rounds an achieved value to few digits. Errors are rounded up, so that a target of the result
/// still allows them.
double rounded(Target::Kind kind, double value) {
  if (kind == Target::Kind::Ratio) return std::round(10 * value) / 10;
  if (kind == Target::Kind::Size) return value;
  const double near = in_three_digits(value);
  return near < value ? in_three_digits(1.01 * near) : near;
}

}  // namespace

TargetControl::TargetControl(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      value_(new NumberBox(this)),
      trouble_(new QLabel(this)) {
  kind_->setAccessibleName(tr("Target"));
  kind_->addItem(tr("Compression ratio"), static_cast<int>(Target::Kind::Ratio));
  kind_->addItem(tr("Size of the motion"), static_cast<int>(Target::Kind::Size));
  kind_->addItem(tr("Error (eps_x)"), static_cast<int>(Target::Kind::Error));
  kind_->addItem(tr("Hard maximum"), static_cast<int>(Target::Kind::MaxError));
  kind_->addItem(tr("Visibility"), static_cast<int>(Target::Kind::Visibility));
  kind_->setToolTip(
      tr("Sizes: the compression ratio (bytes of the channels as 32-bit floats, divided by "
         "compressed motion bytes) or the motion bytes themselves. Qualities: the weighted RMS "
         "error eps_x, the largest error of any point at any frame, or visibility, the largest "
         "error as a multiple of what people notice: at 1, no error is visible."));
  slider_->setAccessibleName(tr("Target on a slider"));
  slider_->setRange(0, LogScale().steps);
  slider_->setPageStep(50);
  slider_->setToolTip(tr(
      "Drag to change the target. A draft appears at once and is refined when you pause. What the "
      "preset promises of head, hands and fingers is kept beside an error."));
  value_->setAccessibleName(tr("Target value"));
  value_->setToolTip(tr("Target as a number; type it or use the arrows."));
  trouble_->setWordWrap(true);
  trouble_->setAccessibleName(tr("Problem with the target"));
  trouble_->hide();

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->addWidget(kind_, 0, 0);
  grid->addWidget(value_, 0, 1);
  grid->addWidget(trouble_, 1, 0, 1, 2);
  grid->addWidget(slider_, 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);

  connect(kind_, &QComboBox::activated, this, [this](int index) {
    const auto kind = static_cast<Target::Kind>(kind_->itemData(index).toInt());
    if (kind == target_.kind) return;
    values_[target_.kind] = target_.value;
    choose({kind, values_.contains(kind) ? values_[kind] : unitOf(kind).first});
  });
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    choose({target_.kind, unitOf(target_.kind).scale.chosen(position)});
  });
  connect(value_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (value <= 0) return setTrouble(tr("The target must be above zero."));
    choose({target_.kind, unitOf(target_.kind).value(value)});
  });
  show();
}

void TargetControl::setTarget(const Target& target) {
  assert(target.kind != Target::Kind::CoefficientRatio);
  if (target.kind != target_.kind) values_[target_.kind] = target_.value;
  target_ = target;
  show();
}

void TargetControl::setAchieved(const std::map<Target::Kind, double>& achieved) {
  for (const auto& [kind, value] : achieved)
    if (value > 0) values_[kind] = rounded(kind, value);
}

void TargetControl::setTrouble(const QString& trouble, const QString& details) {
  trouble_->setText(trouble.isEmpty() ? QString() : QStringLiteral("⚠ %1").arg(trouble));
  trouble_->setToolTip(translatedSentence(details));
  trouble_->setVisible(!trouble.isEmpty());
}

QString TargetControl::trouble() const {
  return trouble_->text();
}

void TargetControl::choose(const Target& target) {
  target_ = target;
  setTrouble({});
  show();
  emit targetChanged(target_);
}

void TargetControl::show() {
  const QSignalBlocker block_kind(kind_);
  const QSignalBlocker block_slider(slider_);
  const QSignalBlocker block_value(value_);
  const Unit unit = unitOf(target_.kind);
  kind_->setCurrentIndex(kind_->findData(static_cast<int>(target_.kind)));
  slider_->setValue(unit.scale.position(target_.value, slider_->value()));
  value_->setDecimalsShown(unit.shown_decimals, unit.most_decimals);
  value_->setSuffix(unit.suffix);
  value_->setValue(unit.shown(target_.value));
}

}  // namespace mocapress
