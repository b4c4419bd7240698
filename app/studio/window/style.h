// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace mocapress {

/// Fusion, with check boxes whose outline is seen on dark ground too.
class StudioStyle : public QProxyStyle {
 public:
  StudioStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace mocapress
