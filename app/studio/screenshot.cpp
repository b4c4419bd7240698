// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/screenshot.h"

#include <QPixmap>
#include <QScreen>
#include <QWidget>

namespace mocapress {

bool writeScreenshot(const QWidget& window, const QString& path) {
  const QRect area = window.frameGeometry();
  return window.screen()->grabWindow(0, area.x(), area.y(), area.width(), area.height()).save(path);
}

}  // namespace mocapress
