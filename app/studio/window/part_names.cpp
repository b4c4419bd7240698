// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/part_names.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QScrollArea>

namespace mocapress {
namespace {

/// A name for the purpose of a chooser: its accessible name, the text of its label or, in dialogs
/// of Qt, the chosen entry. A screen reader on Linux reads the chosen entry as the name of a
/// chooser, and learns its purpose from a label beside it or from the description.
QString purposeOf(QComboBox* box) {
  if (!box->accessibleName().isEmpty()) return box->accessibleName();
  const auto labels = QAccessible::queryAccessibleInterface(box)->relations(QAccessible::Label);
  return labels.isEmpty() ? box->currentText() : labels.front().first->text(QAccessible::Name);
}

}  // namespace

/// Acts on the Polish event: a widget gets it once, before it is first shown and after its
/// constructor.
bool PartNames::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Polish || !watched->isWidgetType()) return false;
  auto* const widget = static_cast<QWidget*>(watched);
  const QWidget* const whole = widget->parentWidget();
  if (auto* box = qobject_cast<QComboBox*>(widget)) {
    box->view()->setAccessibleName(purposeOf(box));
    if (box->toolTip().isEmpty()) box->setAccessibleDescription(box->accessibleName());
  }
  if (qobject_cast<const QScrollArea*>(widget)) widget->setFocusPolicy(Qt::NoFocus);
  if (!whole || !widget->accessibleName().isEmpty()) return false;
  if (widget->objectName() == QLatin1String("qt_toolbar_ext_button"))
    widget->setAccessibleName(tr("More tools"));
  if (qobject_cast<const QAbstractButton*>(widget) && qobject_cast<const QLineEdit*>(whole))
    widget->setAccessibleName(tr("Clear"));
  else if (qobject_cast<const QLineEdit*>(widget))
    widget->setAccessibleName(whole->accessibleName());
  return false;
}

}  // namespace mocapress
