// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/qt/studio_at_work.h"

#include <QDropEvent>
#include <QMimeData>
#include <filesystem>
#include <set>

#include "app/studio/window/screenshot.h"
#include "core/formats/motion_file.h"
#include "widgets/viewport/viewport.h"

namespace mocapress::test {
namespace {

// Each picture is also saved in the width of the guide's; the README's studio.png is library.
constexpr int kGuideWidth = 900;

}  // namespace

QString picturePath(const QString& name) {
  const QDir folder(QStringLiteral(MOCAPRESS_BINARY_DIR "/pictures"));
  folder.mkpath(QStringLiteral("guide"));
  return folder.filePath(name + QStringLiteral(".png"));
}

int differing(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
  return count;
}

std::size_t coloursIn(const QImage& picture, const QRect& area) {
  std::set<QRgb> colours;
  for (int y = area.top(); y < area.bottom(); y += 2)
    for (int x = area.left(); x < area.right(); x += 2) colours.insert(picture.pixel(x, y));
  return colours.size();
}

int pixelsNear(const QImage& picture, const QRect& area, const QColor& colour) {
  int count = 0;
  for (int y = area.top(); y < area.bottom(); ++y)
    for (int x = area.left(); x < area.right(); ++x) {
      const QColor seen = picture.pixelColor(x, y);
      const int away = std::abs(seen.hsvHue() - colour.hsvHue());
      count += seen.hsvSaturation() > 100 && std::min(away, 360 - away) < 8;
    }
  return count;
}

void drop(QWidget& widget, const QList<QUrl>& urls) {
  QMimeData data;
  data.setUrls(urls);
  // Qt delivers a drop only after a drag entered.
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &drop);
}

void writeWalks(const QString& folder, int count) {
  QDir().mkpath(folder);
  const Motion walk =
      read_motion(std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/human_walk.amc")
          .motion;
  for (int i = 0; i < count; ++i) {
    Motion part = walk;
    part.clip.channels = walk.clip.channels.topRows(60 + 30 * i).eval();
    write_motion(QStringLiteral("%1/walk%2.bvh").arg(folder).arg(i).toStdU16String(), part);
  }
}

QImage Studio::picture(const QString& name) {
  QSignalSpy captured(window_.views().viewport, &Viewport::captured);
  window_.views().viewport->capture();
  EXPECT_TRUE(captured.count() > 0 || captured.wait(kPatience));
  runDueEvents();
  EXPECT_TRUE(writeScreenshot(window_, picturePath(name)));
  QImage picture(picturePath(name));
  // In the size that the guide uses.
  picture.scaledToWidth(kGuideWidth, Qt::SmoothTransformation)
      .save(picturePath(QStringLiteral("guide/") + name));
  return picture;
}

}  // namespace mocapress::test
