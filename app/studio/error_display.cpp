// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/error_display.h"

#include <QAction>
#include <QSettings>

namespace mocapress {
namespace {

const QString kSetting = QStringLiteral("view/errors-in-degrees");

}  // namespace

ErrorDisplay::ErrorDisplay(QObject* parent)
    : QObject(parent),
      distances_(new ErrorScaleChoice(ErrorQuantity::Distance, this)),
      angles_(new ErrorScaleChoice(ErrorQuantity::Angle, this)),
      in_degrees_(new QAction(tr("Errors in &Degrees"), this)) {
  in_degrees_->setIconText(tr("Degrees"));
  in_degrees_->setShortcut(Qt::SHIFT | Qt::Key_E);
  in_degrees_->setToolTip(
      tr("Heat map and error graph: by how many degrees joints are turned in the world, instead of "
         "how far they are off (%1)")
          .arg(in_degrees_->shortcut().toString(QKeySequence::NativeText)));
  in_degrees_->setCheckable(true);
  in_degrees_->setChecked(QSettings().value(kSetting, false).toBool());
  connect(in_degrees_, &QAction::toggled, this, [this](bool checked) {
    QSettings().setValue(kSetting, checked);
    emit changed();
  });
  for (const ErrorScaleChoice* choice : {distances_, angles_})
    connect(choice, &ErrorScaleChoice::changed, this, &ErrorDisplay::changed);
}

ErrorQuantity ErrorDisplay::quantity() const {
  return in_degrees_->isChecked() ? ErrorQuantity::Angle : ErrorQuantity::Distance;
}

}  // namespace mocapress
