// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to compare figures in the 3D view. Needs an X display with OpenGL (Xvfb is enough).
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QWindow>

#include "core/motion/landmarks.h"
#include "tests/qt/patience.h"
#include "tests/qt/pixel_colour.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

/// An upright stick of three joints, 60 cm apart.
Skeleton stick() {
  Skeleton skeleton;
  Joint foot;
  foot.parent = -1;
  foot.offset = {0, 5, 25};
  foot.channels = {ChannelKind::TranslationX};
  skeleton.add(foot);
  for (int above = 0; above < 2; ++above) {
    Joint joint;
    joint.parent = above;
    joint.offset = {0, 60, 0};
    skeleton.add(joint);
  }
  return skeleton;
}

constexpr int kMiddle = 1;

/// Two frames, the second 30 cm along x.
Viewport::Tracks stickAt(double x_cm) {
  Clip clip;
  clip.channels = Eigen::Vector2d(x_cm, x_cm + 30);
  return std::make_shared<const Eigen::MatrixXd>(landmark_tracks(stick(), clip));
}

bool isDarkGrey(QRgb pixel) {
  return qGray(pixel) < 150 && std::abs(qRed(pixel) - qBlue(pixel)) < 40 &&
         std::abs(qRed(pixel) - qGreen(pixel)) < 40;
}

class ViewModes : public testing::Test {
 protected:
  void SetUp() override {
    viewport_.resize(800, 480);
    viewport_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&viewport_));
    viewport_.setSkeleton(stick());
    viewport_.setOriginal(original_);
    viewport_.setCompressed(compressed_);
  }

  QImage picture(const ViewOptions& options) {
    viewport_.setOptions(options);
    QSignalSpy captured(&viewport_, &Viewport::captured);
    viewport_.capture();
    EXPECT_TRUE(captured.wait(kPatience));
    return captured.isEmpty() ? QImage() : captured.first().first().value<QImage>();
  }

  QPoint seen(const Viewport::Tracks& tracks, int frame = 0) const {
    return viewport_.camera().project(landmarkAt(*tracks, frame, kMiddle))->toPoint();
  }

  QWindow* scene() {
    for (QWindow* window : QGuiApplication::allWindows())
      if (window->inherits("mocapress::Scene")) return window;
    return nullptr;
  }

  const Viewport::Tracks original_ = stickAt(30);
  const Viewport::Tracks compressed_ = stickAt(-30);
  Viewport viewport_;
};

TEST_F(ViewModes, FourViewsShowTheFigureFromEverySide) {
  const QImage four = picture({.quartered = true});
  ASSERT_EQ(four.width(), 800);
  const auto red_in = [&](const QRect& area) {
    int count = 0;
    for (int x = area.left(); x <= area.right(); ++x)
      for (int y = area.top() + 40; y <= area.bottom(); ++y)  // below the titles
        count += isRed(four.pixel(x, y)) ? 1 : 0;
    return count;
  };
  for (const QPoint& corner : {QPoint(0, 0), QPoint(400, 0), QPoint(0, 240), QPoint(400, 240)})
    EXPECT_GT(red_in({corner, QSize(400, 240)}), 50) << corner.x() << ' ' << corner.y();
  EXPECT_TRUE(isRed(four.pixel(seen(compressed_))));  // the first view is the camera's
}

TEST_F(ViewModes, AClickInAnyOfFourViewsFindsTheJointThere) {
  picture({.quartered = true});
  QSignalSpy clicked(&viewport_, &Viewport::jointClicked);
  const QPoint in_front = viewport_.camera()
                              .along(ViewAxis::Front)
                              .project(landmarkAt(*compressed_, 0, kMiddle))
                              ->toPoint();
  QTest::mouseClick(scene(), Qt::LeftButton, {}, in_front + QPoint(400, 0));
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].toInt(), kMiddle);
}

TEST_F(ViewModes, ExaggeratesTheDifferenceAndSaysSo) {
  const Viewport::Tracks near_by = stickAt(20);
  viewport_.setCompressed(near_by);
  const QImage plain = picture({});
  const QImage more = picture({.exaggeration = 5});
  const Viewport::Tracks expected = stickAt(-20);  // 30 - 5 * 10
  EXPECT_TRUE(isRed(more.pixel(seen(expected))));
  EXPECT_FALSE(isRed(plain.pixel(seen(expected))));
  int changed = 0;  // the words at the top right
  for (int x = 680; x < 788; ++x)
    for (int y = 12; y < 38; ++y) changed += plain.pixel(x, y) != more.pixel(x, y) ? 1 : 0;
  EXPECT_GT(changed, 200);
}

TEST_F(ViewModes, FramesTheSelectedJoint) {
  picture({});
  const float before = viewport_.camera().distance();
  viewport_.setSelectedJoint(kMiddle);
  viewport_.frameJoint();
  EXPECT_LT(viewport_.camera().distance(), before / 2);
  EXPECT_LT((viewport_.camera().target() - landmarkAt(*original_, 0, kMiddle)).length(), 1e-3F);
}

TEST_F(ViewModes, SideBySideShowsEachInItsHalfAndSwapExchangesThem) {
  for (const bool swapped : {false, true}) {
    const QImage sides = picture({.mode = ViewMode::SideBySide, .swapped = swapped});
    const QPoint half(400, 0);
    const QPoint grey = seen(original_) + (swapped ? half : QPoint());
    const QPoint red = seen(compressed_) + (swapped ? QPoint() : half);
    EXPECT_TRUE(isDarkGrey(sides.pixel(grey))) << swapped;
    EXPECT_TRUE(isRed(sides.pixel(red))) << swapped;
    EXPECT_FALSE(isRed(sides.pixel(red.x() < 400 ? red + half : red - half)));
  }
}

TEST_F(ViewModes, WipeShowsTheOriginalLeftAndTheCompressedRightOfTheDivider) {
  const QPoint grey = seen(original_);
  const QPoint red = seen(compressed_);
  const auto shareRightOf = [](const QPoint& point) { return (point.x() + 25) / 800.0; };
  const auto shareLeftOf = [](const QPoint& point) { return (point.x() - 25) / 800.0; };
  const QImage left = picture({.mode = ViewMode::Wipe, .divider = shareLeftOf(red)});
  EXPECT_TRUE(isRed(left.pixel(red)));
  const QImage right = picture({.mode = ViewMode::Wipe, .divider = shareRightOf(red)});
  EXPECT_FALSE(isRed(right.pixel(red)));
  EXPECT_TRUE(
      isDarkGrey(picture({.mode = ViewMode::Wipe, .divider = shareRightOf(grey)}).pixel(grey)));
  EXPECT_FALSE(
      isDarkGrey(picture({.mode = ViewMode::Wipe, .divider = shareLeftOf(grey)}).pixel(grey)));
}

TEST_F(ViewModes, TheDividerFollowsTheMouseAndTheCameraStays) {
  picture({.mode = ViewMode::Wipe});
  QSignalSpy moved(&viewport_, &Viewport::dividerMoved);
  const QVector3D eye = viewport_.camera().eye();
  QTest::mousePress(scene(), Qt::LeftButton, {}, {402, 200});
  QTest::mouseMove(scene(), {200, 210});
  QTest::mouseRelease(scene(), Qt::LeftButton, {}, {200, 210});
  ASSERT_FALSE(moved.isEmpty());
  EXPECT_NEAR(viewport_.options().divider, 0.25, 0.01);
  EXPECT_EQ(viewport_.camera().eye(), eye);
}

TEST_F(ViewModes, BlinkingShowsNowOneNowTheOther) {
  const QPoint red = seen(compressed_);
  bool with = false;
  bool without = false;
  const auto both_were_seen = [&] {
    const bool now = isRed(picture({.blinking = true}).pixel(red));
    (now ? with : without) = true;
    return with && without;
  };
  EXPECT_TRUE(QTest::qWaitFor(both_were_seen, kPatience));
}

TEST_F(ViewModes, ColoursByErrorFromVioletToYellowWithALegend) {
  const QPoint joint = seen(compressed_);
  const auto errors = [](float cm) {
    return std::make_shared<const Eigen::MatrixXf>(Eigen::MatrixXf::Constant(2, 3, cm));
  };
  viewport_.setErrors(errors(0), {2});
  const QRgb least = picture({.by_error = true}).pixel(joint);
  EXPECT_GT(qBlue(least), qGreen(least) + 20);  // violet
  viewport_.setErrors(errors(2), {2});
  const QImage worst = picture({.by_error = true});
  EXPECT_GT(qGreen(worst.pixel(joint)), qBlue(worst.pixel(joint)) + 60);  // yellow
  EXPECT_GT(qRed(worst.pixel(joint)), qBlue(worst.pixel(joint)) + 60);
  // The legend's colours, in the lower right corner, run from violet to yellow.
  const int y = 480 - 12 - 46 + 13;
  const QRgb from = worst.pixel(800 - 12 - 252 + 20, y);
  const QRgb to = worst.pixel(800 - 12 - 34, y);
  EXPECT_GT(qBlue(from), qGreen(from) + 20);
  EXPECT_GT(qGreen(to), qBlue(to) + 60);
}

TEST_F(ViewModes, NamesTheFiguresAtTheTopOfTheirPanes) {
  const QImage sides = picture({.mode = ViewMode::SideBySide});
  const QPoint dot(12 + 8 + 5, 12 + 13);  // one in each title
  EXPECT_TRUE(isDarkGrey(sides.pixel(dot)));
  EXPECT_TRUE(isRed(sides.pixel(dot + QPoint(400, 0))));
}

TEST_F(ViewModes, InPlaceTheRootStays) {
  const QPoint before = seen(compressed_, 0);
  viewport_.setFrame(1);
  EXPECT_FALSE(isRed(picture({}).pixel(before)));
  EXPECT_TRUE(isRed(picture({.in_place = true}).pixel(before)));
}

TEST_F(ViewModes, TheFloorIsSeenFromAbove) {
  viewport_.lookAlong(ViewAxis::Top);
  const QVector3D down = viewport_.camera().target() - viewport_.camera().eye();
  EXPECT_LT(down.normalized().y(), -0.99f);
  viewport_.resetCamera();
  EXPECT_GT((viewport_.camera().target() - viewport_.camera().eye()).normalized().y(), -0.5f);
}

TEST_F(ViewModes, ThePathOfTheJointIsDrawn) {
  viewport_.setSelectedJoint(kMiddle);
  const QPoint ahead = (seen(compressed_, 0) + seen(compressed_, 1)) / 2;
  EXPECT_FALSE(isRed(picture({}).pixel(ahead)));
  EXPECT_TRUE(isRed(picture({.path = true}).pixel(ahead)));
}

TEST_F(ViewModes, AClickFindsTheJointInTheHalfItIsSeenIn) {
  picture({.mode = ViewMode::SideBySide});
  QSignalSpy clicked(&viewport_, &Viewport::jointClicked);
  QTest::mouseClick(scene(), Qt::LeftButton, {}, seen(compressed_) + QPoint(400, 0));
  QTest::mouseClick(scene(), Qt::LeftButton, {}, seen(compressed_));  // the original is elsewhere
  QTest::mouseClick(scene(), Qt::LeftButton, {}, seen(original_));
  ASSERT_EQ(clicked.size(), 2);
  EXPECT_EQ(clicked[0][0].toInt(), kMiddle);
  EXPECT_EQ(clicked[1][0].toInt(), kMiddle);
}

}  // namespace
}  // namespace mocapress
