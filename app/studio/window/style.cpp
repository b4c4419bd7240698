// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace mocapress {

StudioStyle::StudioStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void StudioStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
  QColor outline = option->palette.color(QPalette::Text);
  outline.setAlphaF(option->state & State_Enabled ? 0.5F : 0.25F);
  painter->save();
  painter->setPen(outline);
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  painter->restore();
}

}  // namespace mocapress
