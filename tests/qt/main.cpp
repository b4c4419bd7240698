// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include <QTemporaryDir>

#include "app/studio/window/theme.h"
#include "core/baselines/rivals.h"
#include "widgets/viewport/viewport.h"

int main(int argc, char** argv) {
  mocapress::add_rivals();
  testing::InitGoogleTest(&argc, argv);
  // CTest lists the tests, possibly without a display.
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  mocapress::prepareViewport();
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  qputenv("XDG_CACHE_HOME", settings.path().toUtf8());
  qputenv("XDG_DATA_HOME", settings.filePath(QStringLiteral("data")).toUtf8());
  // Tests do not depend on a desktop. Without one, libdbus would start a bus of its own, and leak
  // memory if it cannot.
  qputenv("DBUS_SESSION_BUS_ADDRESS", "disabled:");
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("mocapress-tests"));
  QCoreApplication::setApplicationName(QStringLiteral("Mocapress"));
  QApplication::setStyle(new mocapress::StudioStyle);
  return RUN_ALL_TESTS();
}
