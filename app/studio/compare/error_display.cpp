// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/error_display.h"

#include <QAction>
#include <QSettings>

namespace mocapress {

namespace {

constexpr double kAutomatic = 0;

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
  const double chosen = QSettings().value(settingOf(quantity), kAutomatic).toDouble();
  for (QAction* action : actions())
    if (action->data().toDouble() == chosen) action->setChecked(true);
  if (!checkedAction())
    for (QAction* action : actions())
      if (action->data().toDouble() == kAutomatic) action->setChecked(true);
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

namespace {

const QString kInDegrees = QStringLiteral("view/errors-in-degrees");
const QString kAsSeen = QStringLiteral("view/errors-as-seen");

}  // namespace

ErrorDisplay::ErrorDisplay(QObject* parent)
    : QObject(parent),
      distances_(new ErrorScaleChoice(ErrorQuantity::Distance, this)),
      angles_(new ErrorScaleChoice(ErrorQuantity::Angle, this)),
      in_degrees_(new QAction(tr("Errors in &Degrees"), this)),
      as_seen_(new QAction(tr("Visible Errors"), this)) {
  in_degrees_->setIconText(tr("Degrees"));
  in_degrees_->setShortcut(Qt::SHIFT | Qt::Key_E);
  in_degrees_->setToolTip(tr("Show rotation errors of joints (in degrees, world space) instead of "
                             "distances in heat map and error graph (%1)")
                              .arg(in_degrees_->shortcut().toString(QKeySequence::NativeText)));
  as_seen_->setIconText(tr("Seen"));
  as_seen_->setShortcut(Qt::SHIFT | Qt::Key_S);
  as_seen_->setToolTip(tr("Show visible errors of joints instead of distances in the heat map (%1)")
                           .arg(as_seen_->shortcut().toString(QKeySequence::NativeText)));
  auto* one_of_them = new QActionGroup(this);
  one_of_them->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const auto& [action, setting] : {std::pair(in_degrees_, kInDegrees), {as_seen_, kAsSeen}}) {
    action->setCheckable(true);
    action->setChecked(QSettings().value(setting, false).toBool());
    one_of_them->addAction(action);
    connect(action, &QAction::toggled, this, [this, setting = setting](bool checked) {
      QSettings().setValue(setting, checked);
      emit changed();
    });
  }
  for (const ErrorScaleChoice* choice : {distances_, angles_})
    connect(choice, &ErrorScaleChoice::changed, this, &ErrorDisplay::changed);
}

ErrorQuantity ErrorDisplay::quantity() const {
  return in_degrees_->isChecked() ? ErrorQuantity::Angle : ErrorQuantity::Distance;
}

bool ErrorDisplay::tellsSight() const {
  return as_seen_->isChecked();
}

}  // namespace mocapress
