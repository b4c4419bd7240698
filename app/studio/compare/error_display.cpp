// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/error_display.h"

#include <QAction>
#include <QSettings>

namespace mocapress {
namespace {

const QString kInDegrees = QStringLiteral("view/errors-in-degrees");
const QString kAsSeen = QStringLiteral("view/errors-as-seen");

}  // namespace

ErrorDisplay::ErrorDisplay(QObject* parent)
    : QObject(parent),
      distances_(new ErrorScaleChoice(ErrorQuantity::Distance, this)),
      angles_(new ErrorScaleChoice(ErrorQuantity::Angle, this)),
      in_degrees_(new QAction(tr("Errors in &Degrees"), this)),
      as_seen_(new QAction(tr("What the Eye Sees"), this)) {
  in_degrees_->setIconText(tr("Degrees"));
  in_degrees_->setShortcut(Qt::SHIFT | Qt::Key_E);
  in_degrees_->setToolTip(
      tr("Heat map and error graph: by how many degrees joints are turned in the world, instead of "
         "how far they are off (%1)")
          .arg(in_degrees_->shortcut().toString(QKeySequence::NativeText)));
  as_seen_->setIconText(tr("Seen"));
  as_seen_->setShortcut(Qt::SHIFT | Qt::Key_S);
  as_seen_->setToolTip(
      tr("Heat map: where people notice that joints are off, instead of how far they are off (%1)")
          .arg(as_seen_->shortcut().toString(QKeySequence::NativeText)));
  auto* one_of_them = new QActionGroup(this);
  one_of_them->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const auto& [action, setting] : {std::pair(in_degrees_, kInDegrees), {as_seen_, kAsSeen}}) {
    action->setCheckable(true);
    action->setChecked(QSettings().value(setting, false).toBool());
    one_of_them->addAction(action);
    connect(action, &QAction::toggled, this, [this, setting](bool checked) {
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
