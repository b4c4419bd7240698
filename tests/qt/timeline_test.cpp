// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline.h"

#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <cmath>

#include "tests/qt/patience.h"
#include "widgets/models/colours.h"
#include "widgets/panels/figures_bar.h"
#include "widgets/plots/channel_graph.h"
#include "widgets/plots/heat_map.h"
#include "widgets/timeline/contact_strip.h"
#include "widgets/timeline/error_strip.h"
#include "widgets/timeline/note_strip.h"
#include "widgets/timeline/pose_strip.h"
#include "widgets/timeline/sight_strip.h"
#include "widgets/timeline/time_ruler.h"

namespace mocapress {
namespace {

const std::vector<QString> kNames = {QStringLiteral("hip"), QStringLiteral("toe")};
constexpr int kFrames = 100;

int countOf(const QImage& picture, const QColor& colour, const QRect& area) {
  int count = 0;
  for (int y = area.top(); y <= area.bottom(); ++y)
    for (int x = area.left(); x <= area.right(); ++x)
      count += picture.pixelColor(x, y).rgb() == colour.rgb();
  return count;
}

class TimelineStrips : public testing::Test {
 protected:
  TimelineStrips() {
    timeline_.setContacts({{1, 20, 59}}, kNames, kFrames);
    ErrorProfile profile{Eigen::VectorXf::Zero(kFrames), Eigen::VectorXf::Zero(kFrames)};
    profile.max.segment(70, 10).setConstant(2);
    timeline_.errors()->setErrors(profile, {2}, kFrames);
    timeline_.resize(500, timeline_.sizeHint().height());
    timeline_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&timeline_));
    left_ = 2 * kStripMargin +
            std::max(timeline_.errors()->labelWidth(), timeline_.contacts()->labelWidth());
  }

  int xOf(double frame) const {
    return static_cast<int>(
        TimeAxis{static_cast<double>(left_), 500.0 - kStripMargin, kFrames}.xOf(frame));
  }

  QPoint onLane(double frame) const { return {xOf(frame), timeline_.contacts()->height() / 2}; }

  Timeline timeline_;
  int left_;
};

TEST_F(TimelineStrips, ShowTheWorstFramesHighAndYellowWhereTheyAre) {
  const QImage picture = timeline_.errors()->grab().toImage();
  const int height = timeline_.errors()->height();
  const QRect bad(xOf(71), 10, xOf(79) - xOf(71), height - 14);
  const QRect good(xOf(81), 10, xOf(99) - xOf(81), height - 14);
  EXPECT_GT(countOf(picture, viridis(1), bad), bad.width() * bad.height() / 2);
  EXPECT_EQ(countOf(picture, viridis(1), good), 0);
}

TEST_F(TimelineStrips, MarkJumpsOfOneFrame) {
  const QColor mark(0xd5, 0x5e, 0x00);
  const QRect above(0, 0, 500, 8);
  EXPECT_EQ(countOf(timeline_.errors()->grab().toImage(), mark, above), 0);
  timeline_.errors()->setGlitches({{30, 1, 2.0}}, kNames);
  const QRect there(xOf(30) - 4, 0, 12, 8);
  EXPECT_GT(countOf(timeline_.errors()->grab().toImage(), mark, there), 10);
}

TEST_F(TimelineStrips, AClickSeeksAndShiftDragChoosesTheRange) {
  QSignalSpy seek(&timeline_, &Timeline::seekRequested);
  QTest::mouseClick(timeline_.errors(), Qt::LeftButton, {}, {xOf(40) + 2, 20});
  ASSERT_EQ(seek.count(), 1);
  EXPECT_EQ(seek[0][0].toInt(), 40);
  FrameRange range;
  QObject::connect(timeline_.errors(), &ErrorStrip::rangeChosen,
                   [&](const FrameRange& chosen) { range = chosen; });
  QTest::mousePress(timeline_.errors(), Qt::LeftButton, Qt::ShiftModifier, {xOf(60) + 2, 20});
  QMouseEvent move(QEvent::MouseMove, QPointF(xOf(30) + 2, 20), QPointF(), Qt::NoButton,
                   Qt::LeftButton, Qt::ShiftModifier);
  QCoreApplication::sendEvent(timeline_.errors(), &move);
  EXPECT_EQ(range, FrameRange(30, 60));
}

TEST_F(TimelineStrips, FoldAwayAndStayFolded) {
  const auto unfolded = [](Timeline& timeline) {
    QCoreApplication::sendPostedEvents();
    timeline.grab();  // lays it out
    return timeline.errors()->height() > 0;
  };
  ASSERT_TRUE(unfolded(timeline_));
  for (QAction* fold : timeline_.foldActions())
    if (fold->objectName() == QStringLiteral("timeline-errors")) fold->trigger();
  EXPECT_FALSE(unfolded(timeline_));
  Timeline next;
  next.resize(500, 300);
  next.show();
  EXPECT_FALSE(unfolded(next));
  QSettings().clear();
}

TEST_F(TimelineStrips, ShowPosesAlongTheClip) {
  // Hips at 100 cm, head above them, hand in front: the last frames lie down.
  auto tracks = std::make_shared<Eigen::MatrixXd>(kFrames, 9);
  for (int frame = 0; frame < kFrames; ++frame)
    tracks->row(frame) << 0, 100, 0, 0, frame < kFrames / 2 ? 180 : 100, 0, 60, 100, 0;
  PoseStrip* poses = timeline_.poses();
  EXPECT_TRUE(poses->isHidden());
  poses->setPoses(tracks, {-1, 0, 0}, 0);
  EXPECT_FALSE(poses->isHidden());
  timeline_.grab();
  const QImage picture = poses->grab().toImage();
  const auto inked = [&](double from, double to) {  // pixels in the upper half
    int count = 0;
    for (int x = xOf(from); x < xOf(to); ++x)
      for (int y = 0; y < picture.height() / 2; ++y)
        count += qAbs(qGray(picture.pixel(x, y)) - qGray(picture.pixel(0, 0))) > 40 ? 1 : 0;
    return count;
  };
  EXPECT_GT(inked(5, kFrames / 2.0 - 5), 40);
  EXPECT_EQ(inked(kFrames / 2.0 + 5, kFrames - 1), 0);
  QSignalSpy seek(&timeline_, &Timeline::seekRequested);
  QTest::mouseClick(poses, Qt::LeftButton, {}, {xOf(40) + 2, 20});
  ASSERT_EQ(seek.count(), 1);
  EXPECT_EQ(seek[0][0].toInt(), 40);
  poses->setPoses(nullptr, {}, 0);
  EXPECT_TRUE(poses->isHidden());
}

/// Presses at one frame's middle and releases at another's.
void dragOn(QWidget* widget, const QPoint& from, const QPoint& to) {
  QTest::mousePress(widget, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, QPointF(to), QPointF(), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(widget, &move);
  QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
}

TEST_F(TimelineStrips, ADragOnTheRulerChoosesFramesAndAClickSeeks) {
  TimeRuler* ruler = timeline_.ruler();
  std::optional<FrameRange> range;
  QObject::connect(ruler, &TimeRuler::rangeChosen, [&](const auto& chosen) {
    range = chosen;
    ruler->setRange(chosen);
  });
  QSignalSpy seek(&timeline_, &Timeline::seekRequested);
  QTest::mouseClick(ruler, Qt::LeftButton, {}, {xOf(40) + 2, 5});
  ASSERT_EQ(seek.count(), 1);
  EXPECT_EQ(seek[0][0].toInt(), 40);
  EXPECT_FALSE(range);
  dragOn(ruler, {xOf(60) + 2, 5}, {xOf(30) + 2, 5});
  EXPECT_EQ(range, FrameRange(30, 60));
  dragOn(ruler, {xOf(61), 5}, {xOf(80) + 2, 5});  // its end
  EXPECT_EQ(range, FrameRange(30, 80));
  EXPECT_EQ(seek.count(), 1);
  QTest::mouseDClick(ruler, Qt::LeftButton, {}, {xOf(50), 5});
  EXPECT_FALSE(range);
}

TEST_F(TimelineStrips, TheRulerShowsMoreCareAndAClickChoosesItsFrames) {
  TimeRuler* ruler = timeline_.ruler();
  const int height = ruler->sizeHint().height();
  ruler->setCare({{20, 39, 3}});
  EXPECT_GT(ruler->sizeHint().height(), height) << "it has a lane of its own";
  timeline_.resize(500, timeline_.sizeHint().height());
  QTest::qWait(0);
  const QColor blue(0x00, 0x72, 0xb2);
  const QRect lane(xOf(21), ruler->height() - 12, xOf(39) - xOf(21), 8);
  const QImage picture = ruler->grab().toImage();
  EXPECT_GT(countOf(picture, blue, lane), lane.width() * lane.height() / 2);
  EXPECT_EQ(countOf(picture, blue, lane.translated(xOf(30) - xOf(0), 0)), 0);
  std::optional<FrameRange> range;
  QObject::connect(ruler, &TimeRuler::rangeChosen, [&](const auto& chosen) { range = chosen; });
  QTest::mouseClick(ruler, Qt::LeftButton, {}, lane.center());
  EXPECT_EQ(range, FrameRange(20, 39));
}

TEST_F(TimelineStrips, NumbersOfTheRulerKeepApart) {
  TimeRuler* ruler = timeline_.ruler();
  for (const int frames : {kFrames, 100'000}) {
    ruler->setClip(frames, 30);
    const int apart = ruler->framesApart();
    const int widest = ruler->fontMetrics().horizontalAdvance(QString::number(frames));
    EXPECT_GT(apart * ruler->width() / frames, widest);
    EXPECT_TRUE(QString::number(apart).contains(QRegularExpression(QStringLiteral("^[125]0*$"))));
  }
  const int apart = ruler->framesApart();
  ruler->setWindow({0, 12});
  EXPECT_LT(ruler->framesApart(), apart);
}

TEST_F(TimelineStrips, TheRulerCutsNoNumberAtItsLeftEnd) {
  TimeRuler* ruler = timeline_.ruler();
  const int apart = ruler->framesApart();
  // The mark of the frame before the first one shown is half a frame to the left.
  ruler->setWindow({static_cast<double>(apart), kFrames / 2.0});
  const QImage picture = ruler->grab().toImage();
  const QRect left(xOf(0), 0, 20, ruler->fontMetrics().ascent());
  EXPECT_EQ(countOf(picture, picture.pixelColor(left.topLeft()), left),
            left.width() * left.height());
}

TEST_F(TimelineStrips, AContactsEndCanBeDragged) {
  std::vector<ContactSpan> edited;
  QObject::connect(timeline_.contacts(), &ContactStrip::contactsEdited,
                   [&](const std::vector<ContactSpan>& contacts) { edited = contacts; });
  QSignalSpy seek(&timeline_, &Timeline::seekRequested);
  const auto drag = [&](double from, double to) {
    QTest::mousePress(timeline_.contacts(), Qt::LeftButton, {}, onLane(from));
    QMouseEvent move(QEvent::MouseMove, QPointF(onLane(to)), QPointF(), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(timeline_.contacts(), &move);
    QTest::mouseRelease(timeline_.contacts(), Qt::LeftButton, {}, onLane(to));
  };
  drag(60, 80);  // the last frame ends where frame 60 begins
  EXPECT_EQ(edited, (std::vector<ContactSpan>{{1, 20, 79}}));
  drag(20, 5);
  EXPECT_EQ(edited, (std::vector<ContactSpan>{{1, 5, 79}}));
  EXPECT_EQ(seek.count(), 0);
  drag(40, 45);  // starts between the ends: nothing changes
  EXPECT_EQ(edited, (std::vector<ContactSpan>{{1, 5, 79}}));
  EXPECT_GT(seek.count(), 0);
}

/// Visibility in two windows for hip and toe: the toe is borderline in the first, visible from
/// frame 40 on.
SightPtr toeIsSeen() {
  SightTable table{.window_frames = 40};
  table.times_noticed.resize(2, 2);
  table.times_noticed << 0.25F, 1.5F, 0.5F, 3.F;
  table.cues.setConstant(2, 2, static_cast<std::uint8_t>(Cue::Slide));
  table.noticed_from = Eigen::MatrixXf::Constant(2, 2, 2);
  return std::make_shared<SightTable>(table);
}

QString toolTipAt(QWidget& widget, const QPoint& place) {
  QHelpEvent help(QEvent::ToolTip, place, widget.mapToGlobal(place));
  QApplication::sendEvent(&widget, &help);
  return QToolTip::text();
}

TEST_F(TimelineStrips, DrawBorderlineErrorsAtHalfHeight) {
  SightStrip* strip = timeline_.sight();
  const auto there = [&](int from, int to) {
    return QRect(QPoint(xOf(from) + 1, 0), QPoint(xOf(to) - 2, strip->height() - 1));
  };
  const QColor visible = sightColour(Sight::Visible);
  const QColor borderline = sightColour(Sight::Borderline);
  EXPECT_EQ(countOf(strip->grab().toImage(), visible, strip->rect()), 0) << "unknown";
  strip->setSight(toeIsSeen(), kNames, kFrames);
  const QImage picture = strip->grab().toImage();
  const QRect late = there(40, 100);  // the last window is longer
  const QRect early = there(2, 40);
  EXPECT_GT(countOf(picture, visible, late), 2 * late.width() * late.height() / 3);
  EXPECT_GT(countOf(picture, borderline, early), early.width() * early.height() / 4);
  EXPECT_LT(countOf(picture, borderline, early), early.width() * early.height() / 2);
  EXPECT_EQ(countOf(picture, borderline, late) + countOf(picture, visible, early), 0);
}

TEST_F(TimelineStrips, ShowTheReasonOfAVisibleErrorAndGoThere) {
  SightStrip* strip = timeline_.sight();
  QSignalSpy chosen(strip, &SightStrip::chosen);
  QTest::mouseClick(strip, Qt::LeftButton, {}, {xOf(70) + 2, 10});
  EXPECT_EQ(chosen.count(), 0) << "unknown";
  strip->setSight(toeIsSeen(), kNames, kFrames);
  QTest::mouseClick(strip, Qt::LeftButton, {}, {xOf(70) + 2, 10});
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 70);
  EXPECT_EQ(chosen[0][1].toInt(), 1);
  EXPECT_EQ(toolTipAt(*strip, {xOf(70) + 2, 10}),
            QStringLiteral("toe, frame 71\nvisible: sliding foot 6.00 cm, noticed from 2.00 cm"));
}

class ZoomedTimeline : public TimelineStrips {
 protected:
  void turn(double notches, double frame, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF place(xOf(frame), 20);
    QWheelEvent wheel(place, timeline_.mapToGlobal(place), {}, {0, static_cast<int>(120 * notches)},
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&timeline_, &wheel);
  }

  int frameAt(int x) {
    QSignalSpy seek(&timeline_, &Timeline::seekRequested);
    QTest::mouseClick(timeline_.errors(), Qt::LeftButton, {}, {x, 20});
    return seek.isEmpty() ? -1 : seek.last()[0].toInt();
  }
};

TEST_F(ZoomedTimeline, TheWheelZoomsAboutTheMouse) {
  EXPECT_TRUE(timeline_.scroll()->isHidden());
  const int mouse = xOf(60.5);
  ASSERT_EQ(frameAt(mouse), 60);
  for (int notch = 0; notch < 4; ++notch) {
    turn(1, 60.5);
    EXPECT_EQ(frameAt(mouse), 60);
  }
  EXPECT_LT(timeline_.window().length, 50);
  EXPECT_FALSE(timeline_.scroll()->isHidden());
  turn(100, 60.5);
  EXPECT_GE(timeline_.window().length, 10) << "some frames stay in sight";
  turn(-200, 60.5);
  EXPECT_EQ(timeline_.window(), FrameWindow());
  EXPECT_TRUE(timeline_.scroll()->isHidden());
}

TEST_F(ZoomedTimeline, ShiftAndTheWheelMoveAlongAndSoDoesTheScrollBar) {
  turn(4, 50);
  const FrameWindow before = timeline_.window();
  turn(-1, 50, Qt::ShiftModifier);
  EXPECT_GT(timeline_.window().first, before.first);
  EXPECT_DOUBLE_EQ(timeline_.window().length, before.length);
  turn(-50, 50, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(timeline_.window().first + timeline_.window().length, kFrames);
  timeline_.scroll()->setValue(7);
  EXPECT_DOUBLE_EQ(timeline_.window().first, 7);
}

TEST_F(ZoomedTimeline, ThePlayheadStaysInSight) {
  turn(6, 10);
  for (const int frame : {80, 99, 30, 0}) {
    timeline_.setFrame(frame);
    EXPECT_LE(timeline_.window().first, frame);
    EXPECT_GE(timeline_.window().first + timeline_.window().length, frame + 1);
  }
}

TEST_F(ZoomedTimeline, AnotherClipIsSeenWhole) {
  turn(6, 10);
  timeline_.setContacts({}, kNames, 2 * kFrames);
  EXPECT_EQ(timeline_.window(), FrameWindow());
}

TEST_F(ZoomedTimeline, NothingIsPaintedOverTheNames) {
  const QRect names(0, 0, left_ - 6, timeline_.contacts()->height());
  const auto picture = [&] { return timeline_.contacts()->grab().toImage().copy(names); };
  const QImage before = picture();
  turn(5, 45);
  EXPECT_EQ(picture(), before);
}

TEST_F(TimelineStrips, TheScaleStandsBesideTheErrorsFromVioletToYellow) {
  const QImage strip = timeline_.errors()->grab().toImage();
  const QRect beside(0, 0, left_ - kStripMargin, strip.height());
  EXPECT_GT(countOf(strip, viridis(0), beside), 2);
  EXPECT_GT(countOf(strip, viridis(1), beside), 2);
  timeline_.errors()->setErrors({}, {0.1}, kFrames);
  EXPECT_NE(timeline_.errors()->grab().toImage().copy(beside), strip.copy(beside))
      << "another scale, other numbers";
}

TEST_F(TimelineStrips, AClickOnTheScaleOffersOthersAndSeeksNothing) {
  QAction other(QStringLiteral("5 cm"));
  timeline_.errors()->addAction(&other);
  const QSignalSpy seek(&timeline_, &Timeline::seekRequested);
  QTest::mouseClick(timeline_.errors(), Qt::LeftButton, {}, {10, 25});
  const auto* menu = timeline_.errors()->findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().contains(&other));
  EXPECT_EQ(seek.count(), 0);
}

TEST_F(TimelineStrips, ARightClickOnAStripOffersWhatTheRulerDoesForARange) {
  QAction care(QStringLiteral("More Care"));
  timeline_.ruler()->addAction(&care);
  const QPoint on_errors(timeline_.errors()->width() / 2, 10);
  QContextMenuEvent click(QContextMenuEvent::Mouse, on_errors,
                          timeline_.errors()->mapToGlobal(on_errors));
  QApplication::sendEvent(timeline_.errors(), &click);
  const auto* menu = timeline_.findChild<QMenu*>({}, Qt::FindDirectChildrenOnly);
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().contains(&care));
  EXPECT_TRUE(menu->actions().contains(timeline_.foldActions().front()));
}

TEST_F(TimelineStrips, TheMenusOfAContactAndOfANoteHaveTheCommandsOfTheRange) {
  QAction care(QStringLiteral("More Care"));
  timeline_.addRangeActions({&care});
  timeline_.notes()->setNotes({{kFrames / 2, QStringLiteral("pops"), {}}});
  timeline_.grab();  // lays strips out
  for (QWidget* strip : std::initializer_list<QWidget*>{timeline_.contacts(), timeline_.notes()}) {
    const QPoint middle((left_ + strip->width() - kStripMargin) / 2, 8);
    QContextMenuEvent click(QContextMenuEvent::Mouse, middle, strip->mapToGlobal(middle));
    QApplication::sendEvent(strip, &click);
    const auto* menu = strip->findChild<QMenu*>();
    ASSERT_NE(menu, nullptr) << strip->metaObject()->className();
    EXPECT_NE(menu->actions().front(), &care);
    EXPECT_TRUE(menu->actions().contains(&care));
  }
}

TEST(HeatImage, HasARowALandmarkAndKeepsTheWorstOfFramesThatShareAColumn) {
  Eigen::MatrixXf distances = Eigen::MatrixXf::Zero(1000, 3);
  distances(437, 1) = 2;
  const QImage image = heatImage(distances, {2}, 100);
  ASSERT_EQ(image.size(), QSize(100, 3));
  for (int column = 0; column < 100; ++column)
    for (int row = 0; row < 3; ++row)
      EXPECT_EQ(image.pixelColor(column, row), viridis(column == 43 && row == 1 ? 1 : 0));
}

TEST(HeatMap, AClickTellsFrameAndLandmark) {
  HeatMap map;
  map.setErrors(
      std::make_shared<Distortion>(Distortion{.distances = Eigen::MatrixXf::Ones(kFrames, 2)}),
      kNames, {2});
  map.resize(600, 240);
  QSignalSpy chosen(&map, &HeatMap::chosen);
  QTest::mouseClick(&map, Qt::LeftButton, {}, {600 - 8 - 1, 100 + 60});
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), kFrames - 1);
  EXPECT_EQ(chosen[0][1].toInt(), 1);
  map.setFrame(kFrames - 1);
  map.setCurrentLandmark(1);
  QTest::keyClick(&map, Qt::Key_Up);
  ASSERT_EQ(chosen.count(), 2);
  EXPECT_EQ(chosen[1][1].toInt(), 0);
}

/// Errors of both: each is off by 1 cm at all frames; the toe turns by 10 degrees at the last.
ErrorsPtr errorsOfBoth() {
  Distortion errors{.distances = Eigen::MatrixXf::Ones(kFrames, 2),
                    .turns = Eigen::MatrixXf::Zero(kFrames, 2)};
  errors.turns(kFrames - 1, 1) = 10;
  return std::make_shared<Distortion>(errors);
}

TEST(HeatMap, ShowsDegreesByTheirOwnScale) {
  HeatMap map;
  map.resize(600, 240);
  map.setErrors(errorsOfBoth(), kNames, {1, ErrorQuantity::Distance});
  const QPoint low(300, 180);  // the toe's row
  const QPoint low_last(600 - 8 - 2, 180);
  EXPECT_EQ(map.grab().toImage().pixelColor(low), viridis(1));
  map.setErrors(errorsOfBoth(), kNames, {10, ErrorQuantity::Angle});
  EXPECT_EQ(map.grab().toImage().pixelColor(low), viridis(0));
  EXPECT_EQ(map.grab().toImage().pixelColor(low_last), viridis(1));
}

TEST(HeatMap, TellsBothErrorsOfWhatIsPointedAt) {
  HeatMap map;
  map.resize(600, 240);
  map.show();
  for (const ErrorQuantity quantity : {ErrorQuantity::Distance, ErrorQuantity::Angle}) {
    map.setErrors(errorsOfBoth(), kNames, {10, quantity});
    const QPoint toe_at_the_end(600 - 8 - 1, 180);
    EXPECT_TRUE(toolTipAt(map, toe_at_the_end).endsWith(QStringLiteral("1.00 cm · 10.0°")));
  }
}

TEST(HeatMap, ShowsVisibilityByJointAndTime) {
  HeatMap map;
  map.resize(600, 240);
  map.show();
  map.setErrors(errorsOfBoth(), kNames, {1, ErrorQuantity::Distance});
  const QPoint toe(300, 180);  // in the left half
  const QPoint toe_at_the_end(600 - 8 - 2, 180);
  const auto colourAt = [&](const QPoint& place) { return map.grab().toImage().pixelColor(place); };
  map.setSight(toeIsSeen(), false);
  EXPECT_EQ(colourAt(toe), viridis(1));
  map.setSight(toeIsSeen(), true);
  EXPECT_EQ(colourAt({300, 60}), sightColour(0.5));
  EXPECT_EQ(colourAt({toe.x() - 150, toe.y()}), sightColour(Sight::Borderline));
  EXPECT_EQ(colourAt(toe_at_the_end), sightColour(Sight::Visible));
  EXPECT_EQ(toolTipAt(map, toe_at_the_end),
            QStringLiteral("toe, frame 100: 1.00 cm · 10.0°\n"
                           "visible: sliding foot 6.00 cm, noticed from 2.00 cm"));
  QSignalSpy chosen(&map, &HeatMap::chosen);
  QTest::mouseClick(&map, Qt::LeftButton, {}, toe_at_the_end);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][1].toInt(), 1);
  map.setSight(nullptr, true);
  EXPECT_EQ(colourAt(toe), viridis(1)) << "of an unknown verdict errors are shown";
}

TEST(SightImage, KeepsTheWorstOfFramesThatShareAColumn) {
  SightTable table{.window_frames = 10};
  table.times_noticed = Eigen::MatrixXf::Zero(100, 3);
  table.times_noticed(43, 1) = 2.5F;
  const QImage image = sightImage(table, 1005, 25);
  ASSERT_EQ(image.size(), QSize(25, 3));
  for (int column = 0; column < 25; ++column)
    for (int row = 0; row < 3; ++row)
      EXPECT_EQ(image.pixelColor(column, row), sightColour(column == 10 && row == 1 ? 2.5 : 0.0))
          << column << ' ' << row;
}

/// Colour difference for viewers without red or green cones (Vienot et al. 1999), and the
/// difference in lightness.
double apartWithoutRedOrGreen(const QColor& a, const QColor& b) {
  const auto seen = [](const QColor& colour) {
    const auto linear = [](double part) { return std::pow(part / 255, 2.2); };
    const double both = 0.3 * linear(colour.red()) + 0.7 * linear(colour.green());
    return std::pair(255 * std::pow(both, 1 / 2.2), static_cast<double>(colour.blue()));
  };
  const auto [yellow, blue] = seen(a);
  const auto [other_yellow, other_blue] = seen(b);
  return std::hypot(yellow - other_yellow, blue - other_blue);
}

TEST(SightColour, TellsVerdictsApartWithoutRedOrGreen) {
  const QColor slate = sightColour(1.0);
  const QColor amber = sightColour(2.0);
  const QColor vermilion = sightColour(2.1);
  EXPECT_GT(apartWithoutRedOrGreen(slate, amber), 60);
  EXPECT_GT(apartWithoutRedOrGreen(amber, vermilion), 60);
  EXPECT_GT(apartWithoutRedOrGreen(slate, vermilion), 60);
  EXPECT_LT(sightColour(0.1).lightness(), slate.lightness());
}

TEST(FiguresBar, NamesTheWeightingAndShowsEveryFigure) {
  FiguresBar bar;
  ResultFigures figures{.ratio = 25,
                        .motion_bytes = 7100,
                        .weighting = Weighting::JointOrigins,
                        .eps_cm = 0.12,
                        .p95_cm = 0.34,
                        .p99_cm = 0.56,
                        .max_cm = 0.78,
                        .bits_per_joint_sample = 2.5};
  bar.setFigures(figures);
  QString all;
  for (const QLabel* label : bar.findChildren<QLabel*>()) all += label->text() + QLatin1Char('|');
  for (const char* text :
       {"joint origins", "1.2 mm", "3.4 mm", "5.6 mm", "7.8 mm", "7.10 kB", "25.0 : 1", "2.50"})
    EXPECT_TRUE(all.contains(QString::fromLatin1(text))) << text << " in " << qPrintable(all);
  bar.setFigures({});
  for (const QLabel* label : bar.findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains(QStringLiteral("1.2 mm")));
}

TEST(FiguresBar, HasRoomForLongerNumbersAtOnce) {
  FiguresBar bar;
  bar.resize(1200, 24);
  bar.show();
  bar.setFigures(ResultFigures{.ratio = 9, .motion_bytes = 7100, .bits_per_joint_sample = 2.5});
  bar.setFigures(ResultFigures{.ratio = 11.8,
                               .motion_bytes = 12800,
                               .size_is_estimated = true,
                               .bits_per_joint_sample = 10.5});
  for (const QLabel* label : bar.findChildren<QLabel*>()) {
    if (!label->isVisible()) continue;
    EXPECT_GE(label->width(), label->sizeHint().width()) << qPrintable(label->text());
  }
}

TEST(ChannelGraph, WritesNoLabelOverAnother) {
  ChannelGraph graph;
  graph.resize(560, 220);
  ChannelCurves curves;
  curves.original = Eigen::VectorXd::LinSpaced(kFrames, -11, 21);
  curves.compressed = curves.original + 0.5 * Eigen::VectorXd::Random(kFrames);
  curves.kept.assign(11, {888, 1000});
  graph.setCurves(curves);
  graph.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&graph));
  graph.grab();
  const int line = QFontMetrics(graph.font()).height();
  const auto gap = [](const QCPAxis* axis) {
    const QVector<double> ticks = axis->tickVector();
    return ticks.size() < 2 ? 0.0
                            : std::abs(axis->coordToPixel(ticks[1]) - axis->coordToPixel(ticks[0]));
  };
  const auto plots = graph.findChildren<QCustomPlot*>();
  ASSERT_EQ(plots.size(), 2);
  for (const QCPAxisRect* area : plots[0]->axisRects()) {
    const QCPAxis* axis = area->axis(QCPAxis::atLeft);
    EXPECT_GE(gap(axis), line) << qPrintable(axis->label());
    EXPECT_LE(QFontMetrics(axis->labelFont()).horizontalAdvance(axis->label()), area->height());
  }
  EXPECT_GE(gap(plots[1]->xAxis), line) << "they are upright";
}

TEST(ChannelGraph, DrawsWhatItIsGivenAndSeeks) {
  ChannelGraph graph;
  graph.resize(700, 260);
  graph.setChannels({QStringLiteral("hip tx"), QStringLiteral("hip ty")}, 1);
  ChannelCurves curves;
  curves.original = Eigen::VectorXd::LinSpaced(kFrames, 0, 1);
  curves.compressed = curves.original.array() + 0.1;
  curves.kept = {{2, 2}, {1, 4}};
  graph.setCurves(curves);
  graph.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&graph));
  runDueEvents();
  const QImage picture = graph.grab().toImage();
  EXPECT_GT(countOf(picture, QColor(0xd5, 0x5e, 0x00), picture.rect()), 100);  // compressed
  EXPECT_GT(countOf(picture, QColor(0x00, 0x72, 0xb2), picture.rect()), 400);  // bars
  EXPECT_EQ(graph.channels()->currentIndex(), 1);
}

}  // namespace
}  // namespace mocapress
