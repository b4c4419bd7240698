// SPDX-License-Identifier: GPL-3.0-or-later
// The study window beside the studio's. Needs an X display with OpenGL (Xvfb is enough).
#include "app/studio/study/study_window.h"

#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QAction>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/studio/window/main_window.h"
#include "app/studio/window/screenshot.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/colours.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/study_results.h"
#include "widgets/plots/rate_plot.h"

namespace mocapress {
namespace {

int pixelsOf(const QColor& colour, const QImage& picture) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      count += picture.pixelColor(x, y).rgb() == colour.rgb();
  return count;
}

TEST(StudyWindowOnScreen, DrawsCurvesOfTheOpenClipAndLoadsThePointThatIsClicked) {
  QSettings().clear();
  const QTemporaryDir directory;
  const QString clip = directory.filePath(QStringLiteral("motion.bvh"));
  write_motion(clip.toStdU16String(), test::smooth_motion(200));
  MainWindow window;
  window.show();
  QSignalSpy opened(&window.session(), &Session::settled);
  window.files().open(clip);
  ASSERT_TRUE(opened.wait(kPatience));

  window.actions().study->trigger();
  auto* study = window.findChild<StudyWindow*>();
  ASSERT_TRUE(study);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(study));
  QListWidget* methods = study->panel()->methods();
  for (int i = 0; i < methods->count(); ++i) {
    const QString name = methods->item(i)->data(Qt::UserRole).toString();
    const bool quick = name == QLatin1String("standard") || name == QLatin1String("subsample");
    methods->item(i)->setCheckState(quick ? Qt::Checked : Qt::Unchecked);
  }
  auto* session = window.findChild<StudySession*>();
  EXPECT_EQ(session->settings().clips, QStringList{clip});
  QTest::mouseClick(study->panel()->runButton(), Qt::LeftButton);
  EXPECT_TRUE(session->running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session->running(); }, kPatience));
  RatePlot* plot = study->results()->plot();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return plot->curves().size() == 2 && !plot->curves()[0].line.empty(); }, kPatience));

  runDueEvents();
  const QString picture = directory.filePath(QStringLiteral("study.png"));
  ASSERT_TRUE(writeScreenshot(*study, picture));
  const QImage seen(picture);
  EXPECT_GT(pixelsOf(seriesStyle("standard", false).colour, seen), 200);
  EXPECT_GT(pixelsOf(seriesStyle("subsample", false).colour, seen), 200);

  const RatePoint point = plot->curves()[0].points[1];
  auto* canvas = plot->findChild<QCustomPlot*>();
  QSignalSpy loaded(&window.session(), &Session::settled);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->mapFrom(plot, plot->positionOf(point)));
  ASSERT_TRUE(loaded.count() > 0 || loaded.wait(kPatience));
  EXPECT_NEAR(window.session().document().decoded()->ratio, point.ratio, 1e-9);
  EXPECT_EQ(window.session().document().options().method, Method::Standard);
  QSettings().clear();
}

}  // namespace
}  // namespace mocapress
