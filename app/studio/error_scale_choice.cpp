// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/error_scale_choice.h"

#include <QAction>
#include <QSettings>

#include "widgets/models/length_text.h"

namespace mocapress {
namespace {

const QString kSetting = QStringLiteral("view/error-scale-cm");
constexpr double kAutomatic = 0;
constexpr double kFirst = 5;  // cm: room for the worst frames of usual settings

}  // namespace

ErrorScaleChoice::ErrorScaleChoice(QObject* parent) : QActionGroup(parent) {
  const auto add = [this](const QString& text, double top_cm) {
    QAction* action = addAction(text);
    action->setCheckable(true);
    action->setData(top_cm);
    return action;
  };
  for (const double cm : kErrorScales) add(roundLengthText(cm), cm);
  add(tr("&Automatic"), kAutomatic);
  const double chosen = QSettings().value(kSetting, kFirst).toDouble();
  for (QAction* action : actions())
    if (action->data().toDouble() == chosen) action->setChecked(true);
  if (!checkedAction())
    for (QAction* action : actions())
      if (action->data().toDouble() == kFirst) action->setChecked(true);
  connect(this, &QActionGroup::triggered, this, [this](const QAction* action) {
    QSettings().setValue(kSetting, action->data().toDouble());
    emit changed();
  });
}

ErrorScale ErrorScaleChoice::scaleFor(const DecodedPtr& decoded) const {
  const double chosen = checkedAction()->data().toDouble();
  if (chosen != kAutomatic) return {chosen};
  return errorScaleFor(decoded && decoded->distortion ? decoded->distortion->p99 : 0);
}

}  // namespace mocapress
