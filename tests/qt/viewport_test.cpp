// SPDX-License-Identifier: GPL-3.0-or-later
// The view without OpenGL; other tests run it on a screen.
#include "widgets/viewport/viewport.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QLabel>
#include <QSignalSpy>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"
#include "widgets/viewport/scene.h"

namespace mocapress {
namespace {

TEST(Viewport, SaysThatOpenGlIsMissingAndTakesEveryCall) {
  if (QGuiApplication::platformName() != "offscreen") GTEST_SKIP() << "There is OpenGL here.";
  const Motion motion = test::smooth_motion(3);
  const auto tracks =
      std::make_shared<const Eigen::MatrixXd>(landmark_tracks(motion.skeleton, motion.clip));
  Viewport viewport;
  viewport.show();
  ASSERT_NE(viewport.findChild<QLabel*>(), nullptr);
  EXPECT_TRUE(viewport.findChild<QLabel*>()->text().contains("OpenGL"));

  viewport.setOriginal(nullptr);
  viewport.setFrame(7);
  viewport.setSkeleton(motion.skeleton);
  viewport.setOriginal(tracks);
  viewport.setCompressed(tracks);
  viewport.setFrame(1);
  viewport.setSelectedJoint(2);
  viewport.setFollow(true);
  viewport.resetCamera();
  QSignalSpy captured(&viewport, &Viewport::captured);
  viewport.capture();
  ASSERT_TRUE(captured.wait(1000));
  EXPECT_TRUE(captured.first().first().value<QImage>().isNull());
}

TEST(Ground, DrawsHalfMetresForHumansAndPowersOfTenOfThemForOthers) {
  EXPECT_FLOAT_EQ(gridCell(100), 50);
  EXPECT_FLOAT_EQ(gridCell(220), 50);
  EXPECT_FLOAT_EQ(gridCell(1.8f), 0.5);
  EXPECT_FLOAT_EQ(gridCell(18'000), 5000);
}

}  // namespace
}  // namespace mocapress
