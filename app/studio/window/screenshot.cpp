// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/screenshot.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPixmap>
#include <QScreen>
#include <QWidget>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {

bool writeScreenshot(const QWidget& window, const QString& path) {
  const QRect area = window.frameGeometry();
  const QPixmap picture =
      window.screen()->grabWindow(0, area.x(), area.y(), area.width(), area.height());
  QBuffer file;
  file.open(QIODevice::WriteOnly);
  if (!picture.save(&file, QFileInfo(path).suffix().toUtf8().constData())) return false;
  try {
    write_text(path.toStdU16String(), file.data().toStdString());
    return true;
  } catch (const WriteError&) {
    return false;
  }
}

}  // namespace mocapress
