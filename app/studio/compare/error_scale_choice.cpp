// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/error_scale_choice.h"

#include <QAction>
#include <QSettings>

namespace mocapress {
namespace {

constexpr double kAutomatic = 0;
constexpr double kFirst = 5;  // cm, degrees: room for the worst frames of usual settings

QString settingOf(ErrorQuantity quantity) {
  return quantity == ErrorQuantity::Angle ? QStringLiteral("view/angle-scale-degrees")
                                          : QStringLiteral("view/error-scale-cm");
}

}  // namespace

ErrorScaleChoice::ErrorScaleChoice(ErrorQuantity quantity, QObject* parent)
    : QActionGroup(parent), quantity_(quantity) {
  const auto add = [this](const QString& text, double top) {
    QAction* action = addAction(text);
    action->setCheckable(true);
    action->setData(top);
    return action;
  };
  for (const double top : errorScales(quantity)) add(roundErrorText(top, quantity), top);
  add(tr("&Automatic"), kAutomatic);
  const double chosen = QSettings().value(settingOf(quantity), kFirst).toDouble();
  for (QAction* action : actions())
    if (action->data().toDouble() == chosen) action->setChecked(true);
  if (!checkedAction())
    for (QAction* action : actions())
      if (action->data().toDouble() == kFirst) action->setChecked(true);
  connect(this, &QActionGroup::triggered, this, [this](const QAction* action) {
    QSettings().setValue(settingOf(quantity_), action->data().toDouble());
    emit changed();
  });
}

ErrorScale ErrorScaleChoice::scaleFor(const DecodedPtr& decoded) const {
  const double chosen = checkedAction()->data().toDouble();
  if (chosen != kAutomatic) return {chosen, quantity_};
  if (!decoded || !decoded->distortion) return {.quantity = quantity_};
  const Distortion& errors = *decoded->distortion;
  return errorScaleFor(quantity_ == ErrorQuantity::Angle ? errors.p99_degrees : errors.p99,
                       quantity_);
}

}  // namespace mocapress
