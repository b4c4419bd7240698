// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D view on a screen. Needs an X display with OpenGL (Xvfb is enough).
#include "tests/qt/patience.h"
#include "tests/qt/pixel_colour.h"
#include "widgets/viewport/viewport.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cstdio>
#include <numbers>

#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

Joint joint(int parent, const Eigen::Vector3d& offset) {
  Joint joint;
  joint.parent = parent;
  joint.offset = offset;
  return joint;
}

/// Foot, knee and neck above each other and a hand at one side: the figure has no symmetry.
Skeleton pillar() {
  Skeleton skeleton;
  Joint foot = joint(-1, {0, 5, 25});  // beside the grid's lines
  foot.channels = {ChannelKind::TranslationX};
  skeleton.add(foot);
  skeleton.add(joint(0, {0, 60, 0}));
  skeleton.add(joint(1, {0, 60, 0}));
  skeleton.add(joint(2, {40, 0, 0}));
  return skeleton;
}

constexpr int kKnee = 1;
constexpr int kNeck = 2;

/// Two frames, moved by `cm` along x.
Viewport::Tracks pillarTracks(double start, double cm) {
  Clip clip;
  clip.channels = Eigen::Vector2d(start, start + cm);
  return std::make_shared<const Eigen::MatrixXd>(landmark_tracks(pillar(), clip));
}

class ViewportScreen : public testing::Test {
 protected:
  void SetUp() override {
    viewport_.resize(640, 480);
    viewport_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&viewport_));
    viewport_.setSkeleton(pillar());
    viewport_.setOriginal(original_);
    viewport_.setCompressed(compressed_);
    waitUntilDrawn();
  }

  void waitUntilDrawn() {
    QSignalSpy drawn(&viewport_, &Viewport::drawn);
    ASSERT_TRUE(drawn.wait(kPatience));
  }

  QImage picture() {
    QSignalSpy captured(&viewport_, &Viewport::captured);
    viewport_.capture();
    EXPECT_TRUE(captured.wait(kPatience));
    return captured.isEmpty() ? QImage() : captured.first().first().value<QImage>();
  }

  QPoint seen(const Viewport::Tracks& tracks, int frame, int landmark) const {
    return viewport_.camera().project(landmarkAt(*tracks, frame, landmark))->toPoint();
  }

  /// Shows other tracks and takes a picture.
  QImage pictureOf(const Viewport::Tracks& original, const Viewport::Tracks& compressed) {
    viewport_.setOriginal(original);
    viewport_.setCompressed(compressed);
    return picture();
  }

  /// The window under the mouse.
  QWindow* scene() {
    for (QWindow* window : QGuiApplication::allWindows())
      if (window->inherits("mocapress::Scene")) return window;
    return nullptr;
  }

  const Viewport::Tracks original_ = pillarTracks(15, 25);
  const Viewport::Tracks compressed_ = pillarTracks(-45, 25);
  Viewport viewport_;
};

TEST_F(ViewportScreen, DrawsTheOriginalGreyAndTheCompressedRedWhereTheyAre) {
  const QImage both = picture();
  ASSERT_EQ(both.size(), viewport_.size() * viewport_.devicePixelRatio());
  const QImage neither = pictureOf(nullptr, nullptr);
  for (int landmark = 0; landmark < 4; ++landmark) {
    const QPoint red = seen(compressed_, 0, landmark);
    EXPECT_TRUE(isRed(both.pixel(red))) << landmark;
    EXPECT_FALSE(isRed(neither.pixel(red))) << landmark;
    const QPoint grey = seen(original_, 0, landmark);
    EXPECT_TRUE(isGrey(both.pixel(grey))) << landmark;
    EXPECT_GT(difference(both.pixel(grey), neither.pixel(grey)), 12) << landmark;
  }
}

TEST_F(ViewportScreen, ColoursAJointThatSlidesAndDrawsItsTrail) {
  const auto isViolet = [](QRgb pixel) {
    return qBlue(pixel) > qRed(pixel) + 30 && qRed(pixel) > qGreen(pixel) + 30;
  };
  const QImage before = picture();
  viewport_.setSlides({{{kNeck, 0, 1}, 5, 100, 1}});
  const QImage after = picture();
  const QPoint neck = seen(compressed_, 0, kNeck);
  EXPECT_FALSE(isViolet(before.pixel(neck)));
  EXPECT_TRUE(isViolet(after.pixel(neck)));
  QVector3D middle = (landmarkAt(*compressed_, 0, kNeck) + landmarkAt(*compressed_, 1, kNeck)) / 2;
  middle.setY(0);
  const QPoint trail = viewport_.camera().project(middle)->toPoint();
  EXPECT_FALSE(isViolet(before.pixel(trail)));
  EXPECT_TRUE(isViolet(after.pixel(trail)));
}

TEST_F(ViewportScreen, HidesAFigureWithoutTracks) {
  const QPoint red = seen(compressed_, 0, kNeck);
  const QPoint grey = seen(original_, 0, kNeck);
  const QImage neither = pictureOf(nullptr, nullptr);

  const QImage original_alone = pictureOf(original_, nullptr);
  EXPECT_EQ(original_alone.pixel(red), neither.pixel(red));
  EXPECT_NE(original_alone.pixel(grey), neither.pixel(grey));

  const QImage compressed_alone = pictureOf(nullptr, compressed_);
  EXPECT_NE(compressed_alone.pixel(red), neither.pixel(red));
  EXPECT_EQ(compressed_alone.pixel(grey), neither.pixel(grey));
}

TEST_F(ViewportScreen, MovesWithTheFrame) {
  viewport_.setFrame(1);
  const QImage moved = picture();
  EXPECT_TRUE(isRed(moved.pixel(seen(compressed_, 1, kNeck))));
  EXPECT_FALSE(isRed(moved.pixel(seen(compressed_, 0, kNeck))));
}

TEST_F(ViewportScreen, FollowsTheRoot) {
  viewport_.setFollow(true);
  const QPoint before = seen(original_, 0, kNeck);
  viewport_.setFrame(1);
  EXPECT_EQ(seen(original_, 1, kNeck), before);
}

TEST_F(ViewportScreen, CapturesTheScreenTheRightWayUp) {
  const QPoint head = seen(compressed_, 0, kNeck);
  const QPoint foot = seen(compressed_, 0, 0);
  ASSERT_LT(head.y(), foot.y());
  const QPoint mirrored(head.x(), viewport_.height() - 1 - head.y());
  const QImage image = picture();
  EXPECT_TRUE(isRed(image.pixel(head)));
  EXPECT_FALSE(isRed(image.pixel(mirrored)));
}

/// Pixels of a square around a point that differ between two pictures.
std::vector<QPoint> changedNear(const QPoint& place, const QImage& before, const QImage& after) {
  constexpr int kReach = 30;
  std::vector<QPoint> changed;
  for (int y = place.y() - kReach; y <= place.y() + kReach; ++y)
    for (int x = place.x() - kReach; x <= place.x() + kReach; ++x)
      if (difference(before.pixel(x, y), after.pixel(x, y)) > 12) changed.emplace_back(x, y);
  return changed;
}

TEST_F(ViewportScreen, ARingWithoutColourMarksTheSelectedJointOnBothFigures) {
  const QImage plain = picture();
  viewport_.setSelectedJoint(kKnee);
  const QImage selected = picture();
  for (const auto& tracks : {original_, compressed_}) {
    const QPoint knee = seen(tracks, 0, kKnee);
    EXPECT_EQ(plain.pixel(knee), selected.pixel(knee)) << "the joint keeps its colour";
    const std::vector<QPoint> ring = changedNear(knee, plain, selected);
    EXPECT_GT(ring.size(), 40u);
    EXPECT_TRUE(std::any_of(ring.begin(), ring.end(),
                            [&](const QPoint& p) { return qGray(selected.pixel(p)) > 245; }));
    for (const QPoint& p : ring)
      EXPECT_TRUE(isGrey(selected.pixel(p)) || isRed(selected.pixel(p))) << p.x() << ' ' << p.y();
    const QPoint foot = seen(tracks, 0, 0);
    EXPECT_EQ(plain.pixel(foot), selected.pixel(foot));
  }
}

TEST_F(ViewportScreen, AGhostHasTheSizeOfItsFigure) {
  const QImage alone = pictureOf(nullptr, compressed_);
  const QImage both = pictureOf(compressed_, compressed_);
  for (const int landmark : {0, kKnee, 3})  // the neck is near the titles
    EXPECT_TRUE(changedNear(seen(compressed_, 0, landmark), alone, both).empty()) << landmark;
  const QImage apart = pictureOf(pillarTracks(-44, 25), compressed_);
  EXPECT_FALSE(changedNear(seen(compressed_, 0, kKnee), alone, apart).empty());
}

TEST_F(ViewportScreen, NothingIsDrawnOverTheColoursOfErrors) {
  const auto isYellow = [](QRgb pixel) {
    return qRed(pixel) > qBlue(pixel) + 60 && qGreen(pixel) > qBlue(pixel) + 60;
  };
  viewport_.setErrors(std::make_shared<const Eigen::MatrixXf>(Eigen::MatrixXf::Constant(2, 4, 9)),
                      {.top = 1});
  ViewOptions options;
  options.by_error = true;
  viewport_.setOptions(options);
  const QImage alone = pictureOf(original_, compressed_);
  viewport_.setPinned({{pillarTracks(-43, 25), Qt::blue, {QStringLiteral("nearer")}, {}},
                       {pillarTracks(-47, 25), Qt::darkGreen, {QStringLiteral("beyond")}, {}}});
  const QImage pinned = pictureOf(pillarTracks(-42, 25), compressed_);
  const QPoint knee = seen(compressed_, 0, kKnee);
  const std::vector<QPoint> changed = changedNear(knee, alone, pinned);
  EXPECT_GT(changed.size(), 100u) << "they are seen beside it";
  for (const QPoint& p : changed) EXPECT_FALSE(isYellow(alone.pixel(p))) << p.x() << ' ' << p.y();
}

TEST_F(ViewportScreen, ReportsTheJointThatIsClickedOnEitherFigure) {
  QSignalSpy clicked(&viewport_, &Viewport::jointClicked);
  QTest::mouseClick(scene(), Qt::LeftButton, {}, seen(compressed_, 0, 1) + QPoint(4, 3));
  QTest::mouseClick(scene(), Qt::LeftButton, {}, seen(original_, 0, kNeck));
  QTest::mouseClick(scene(), Qt::LeftButton, {}, {5, 5});
  ASSERT_EQ(clicked.size(), 2);
  EXPECT_EQ(clicked[0][0].toInt(), 1);
  EXPECT_EQ(clicked[1][0].toInt(), kNeck);
}

TEST_F(ViewportScreen, OrbitsOnADragAndPicksNothing) {
  QSignalSpy clicked(&viewport_, &Viewport::jointClicked);
  const QPoint start = seen(compressed_, 0, 1);
  const QVector3D eye = viewport_.camera().eye();
  QTest::mousePress(scene(), Qt::LeftButton, {}, start);
  QTest::mouseMove(scene(), start + QPoint(60, 0));
  QTest::mouseRelease(scene(), Qt::LeftButton, {}, start + QPoint(60, 0));
  EXPECT_GT((viewport_.camera().eye() - eye).length(), 10);
  EXPECT_TRUE(clicked.isEmpty());
}

TEST_F(ViewportScreen, HasANewFigureOnTheScreenWhenItSaysDrawn) {
  for (int round = 0; round < 6; ++round) {
    const bool shown = round % 2 == 0;
    QElapsedTimer clock;
    clock.start();
    viewport_.setCompressed(shown ? compressed_ : nullptr);
    waitUntilDrawn();
    std::printf("setCompressed() to drawn(): %.0f ms\n", 1e-6 * double(clock.nsecsElapsed()));
    const QPoint neck = viewport_.mapToGlobal(seen(compressed_, 0, kNeck));
    const QImage screen = viewport_.screen()->grabWindow(0).toImage();
    EXPECT_EQ(isRed(screen.pixel(neck)), shown);
  }
}

/// The rectangle with colours that only one of two pictures has: the red figure, without its grey
/// shadow.
QRect coloured(const QImage& a, const QImage& b) {
  QRect area;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (!isGrey(a.pixel(x, y)) && difference(a.pixel(x, y), b.pixel(x, y)) > 12)
        area |= QRect(x, y, 1, 1);
  return area;
}

TEST_F(ViewportScreen, ShowsTheWholeFigureOfAnySizeWhenItIsOpenedAndOnReset) {
  for (const double scale : {0.01, 1.0, 100.0}) {
    Skeleton person;
    Joint hips = joint(-1, scale * Eigen::Vector3d(0, 95, 0));
    hips.channels = {ChannelKind::TranslationX};
    person.add(hips);
    person.add(joint(0, scale * Eigen::Vector3d(0, 75, 0)));
    person.add(joint(0, scale * Eigen::Vector3d(15, -90, 0)));
    person.add(joint(1, scale * Eigen::Vector3d(70, -20, 10)));
    Clip clip;
    clip.channels = Eigen::Vector2d(scale * 3000, scale * 3030);  // far from the origin
    const auto tracks = std::make_shared<const Eigen::MatrixXd>(landmark_tracks(person, clip));
    const auto bare = [&] {
      viewport_.setOriginal(nullptr);
      viewport_.setCompressed(nullptr);
      const QImage nothing = picture();
      viewport_.setCompressed(tracks);
      return nothing;
    };
    for (const bool reset : {false, true}) {
      viewport_.resize(reset ? QSize(360, 520) : QSize(640, 480));
      viewport_.setSkeleton(person);
      viewport_.setCompressed(tracks);
      if (reset) {
        QWheelEvent wheel(QPointF(100, 100), QPointF(100, 100), {}, {0, -2400}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(scene(), &wheel);
        viewport_.resetCamera();
      }
      waitUntilDrawn();  // with its new size
      const QImage nothing = bare();
      const QImage image = picture();
      ASSERT_EQ(image.size(), nothing.size());
      const QRect figure = coloured(image, nothing);
      EXPECT_TRUE(image.rect().adjusted(3, 3, -3, -3).contains(figure)) << scale << reset;
      EXPECT_GT(std::max(static_cast<double>(figure.width()) / image.width(),
                         static_cast<double>(figure.height()) / image.height()),
                0.7)
          << scale << reset;
    }
  }
}

TEST_F(ViewportScreen, AFollowingCameraShowsALyingFigureWhole) {
  Skeleton person;
  Joint hips = joint(-1, {0, 95, 0});
  hips.channels = {ChannelKind::TranslationY, ChannelKind::RotationZ};
  person.add(hips);
  person.add(joint(0, {0, 75, 0}));
  person.add(joint(0, {0, -90, 0}));
  Clip clip;
  clip.channels.resize(100, 2);
  for (int t = 0; t < 100; ++t)
    clip.channels.row(t) << (t < 50 ? 0 : -85), (t < 50 ? 0 : std::numbers::pi / 2);
  const auto tracks = std::make_shared<const Eigen::MatrixXd>(landmark_tracks(person, clip));
  viewport_.resize(260, 600);
  viewport_.setSkeleton(person);
  viewport_.setOriginal(tracks);
  viewport_.setFollow(true);
  waitUntilDrawn();
  viewport_.setFrame(99);
  for (int landmark = 0; landmark < 3; ++landmark)
    EXPECT_TRUE(QRect({}, viewport_.size()).contains(seen(tracks, 99, landmark))) << landmark;
}

TEST_F(ViewportScreen, AViewOfAnotherShapeStillShowsAllUntilTheUserLooksAtSomething) {
  viewport_.resize(200, 600);
  const auto whole = [&] {
    for (int landmark = 0; landmark < 4; ++landmark)
      if (!QRect({}, viewport_.size()).contains(seen(original_, 0, landmark))) return false;
    return true;
  };
  EXPECT_TRUE(QTest::qWaitFor(whole, kPatience));
  QTest::mousePress(scene(), Qt::LeftButton, {}, {50, 50});
  QTest::mouseMove(scene(), {110, 50});
  QTest::mouseRelease(scene(), Qt::LeftButton, {}, {110, 50});
  const QVector3D eye = viewport_.camera().eye();
  viewport_.resize(640, 480);
  picture();
  EXPECT_EQ(viewport_.camera().eye(), eye);
}

TEST_F(ViewportScreen, PaintsAFrameOfTwoHundredJointsInLittleTime) {
  Skeleton chain;
  for (int j = 0; j < 200; ++j) chain.add(joint(j - 1, {0, 1, j % 3 - 1.0}));
  const auto tracks = std::make_shared<const Eigen::MatrixXd>(
      landmark_tracks(chain, {.channels = Eigen::MatrixXd(1000, 0)}));
  viewport_.setSkeleton(chain);
  viewport_.setOriginal(tracks);
  viewport_.setCompressed(tracks);
  QElapsedTimer clock;
  clock.start();
  for (int frame = 0; frame < 1000; ++frame) viewport_.setFrame(frame);
  const double microseconds = 1e-3 / 1000 * double(clock.nsecsElapsed());
  std::printf("setFrame() of two figures of 200 joints: %.0f us\n", microseconds);
  EXPECT_LT(microseconds, 5000);
  EXPECT_TRUE(isRed(picture().pixel(seen(tracks, 999, 100))));
}

}  // namespace
}  // namespace mocapress
