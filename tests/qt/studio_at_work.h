// SPDX-License-Identifier: GPL-3.0-or-later
// The real window at work, and pictures of it. Needs an X display with OpenGL (Xvfb is enough).
#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <QLocale>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>

#include "app/studio/window/main_window.h"
#include "tests/qt/patience.h"

namespace mocapress::test {

/// The path of a picture in the build folder.
QString picturePath(const QString& name);

int differing(const QImage& a, const QImage& b);

/// The number of distinct colours; an empty or grey area has few.
std::size_t coloursIn(const QImage& picture, const QRect& area);

/// The number of pixels of about that hue, whatever the light.
int pixelsNear(const QImage& picture, const QRect& area, const QColor& colour);

/// Drops files or folders on a widget.
void drop(QWidget& widget, const QList<QUrl>& urls);

/// Writes starts of the sample walk, so short that encoding them takes no time.
void writeWalks(const QString& folder, int count);

/// A window at work.
class Studio {
 public:
  Studio() {
    window_.resize(1440, 900);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }

  MainWindow* operator->() { return &window_; }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&window_.session(), &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.session().busy(); }, kPatience));
  }

  void open(const QString& path) {
    settleAfter([&] { window_.files().open(path); });
  }

  /// Takes a picture once the 3D view has drawn the latest changes.
  QImage picture(const QString& name);

  QRect areaOf(const QWidget* widget) {
    return {widget->mapTo(&window_, QPoint()), widget->size()};
  }

 private:
  MainWindow window_;
};

class StudioTour : public testing::Test {
 protected:
  StudioTour() {
    QSettings().clear();
    // English needs its translation for plural forms, since the pictures are published.
    const QString language = qEnvironmentVariable("MOCAPRESS_TOUR_LANGUAGE", QStringLiteral("en"));
    QLocale::setDefault(QLocale(language));
    EXPECT_TRUE(texts_.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    QCoreApplication::installTranslator(&texts_);
  }
  ~StudioTour() override {
    QCoreApplication::removeTranslator(&texts_);
    QLocale::setDefault(before_);
    QSettings().clear();
  }
  QLocale before_;
  QTranslator texts_;
  QTemporaryDir directory_;
};

}  // namespace mocapress::test
