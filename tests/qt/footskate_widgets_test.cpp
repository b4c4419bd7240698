// SPDX-License-Identifier: GPL-3.0-or-later
// Widgets for the IK correction, contacts and footskate.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTreeView>
#include <cmath>

#include "tests/support/test_motion.h"
#include "widgets/models/colours.h"
#include "widgets/models/slide_model.h"
#include "widgets/panels/correction_control.h"
#include "widgets/panels/footskate_panel.h"
#include "widgets/panels/number_fields.h"
#include "widgets/timeline/contact_strip.h"
#include "widgets/viewport/trails.h"

namespace mocapress {
namespace {

using Chosen = std::vector<std::optional<EncodeCorrection>>;

Chosen& record(CorrectionControl& control, Chosen& chosen) {
  QObject::connect(&control, &CorrectionControl::correctionChanged,
                   [&](const auto& correction) { chosen.push_back(correction); });
  return chosen;
}

TEST(CorrectionControl, TellsOfTheRatioOnlyWhileFeetAreHeld) {
  CorrectionControl control;
  Chosen told;
  record(control, told);
  EXPECT_FALSE(control.slider()->isEnabled());
  control.hold()->click();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_FALSE(told.back()->ratio) << "it starts with Auto";
  control.findChildren<QCheckBox*>().at(1)->click();
  EXPECT_EQ(told.back()->ratio, 16.0);
  control.slider()->setValue(500);
  EXPECT_NEAR(*told.back()->ratio, std::sqrt(200), 0.05);
  control.hold()->click();
  EXPECT_FALSE(told.back());
}

TEST(CorrectionControl, AutoLeavesTheSplitToTheEncoderAndTheNumberComesBack) {
  CorrectionControl control;
  Chosen told;
  control.setCorrection(EncodeCorrection{.ratio = 8.0});
  record(control, told);
  auto* found = control.findChildren<QCheckBox*>().at(1);
  found->click();
  EXPECT_FALSE(told.back()->ratio);
  EXPECT_FALSE(control.slider()->isEnabled());
  found->click();
  EXPECT_EQ(told.back()->ratio, 8.0);
}

TEST(CorrectionControl, ShowsWhatAutoFound) {
  CorrectionControl control;
  control.setCorrection(EncodeCorrection{});
  Chosen told;
  record(control, told);
  EXPECT_EQ(control.number()->text(), QStringLiteral("–")) << "not known yet";
  control.setFound(5.6);
  EXPECT_TRUE(control.number()->text().startsWith(QStringLiteral("5.6")));
  EXPECT_FALSE(control.number()->isEnabled());
  control.setFound({});
  EXPECT_EQ(control.number()->text(), QStringLiteral("–"));
  EXPECT_TRUE(told.empty());
}

TEST(CorrectionControl, OffersEveryJoint) {
  CorrectionControl control;
  const Skeleton skeleton = test::small_skeleton();
  control.setSkeleton(skeleton);
  Chosen told;
  control.setCorrection(EncodeCorrection{});
  record(control, told);
  const auto actions = control.findChild<QMenu*>()->actions();
  ASSERT_EQ(actions.size(), skeleton.joint_count());
  actions[4]->trigger();
  actions[7]->trigger();
  EXPECT_EQ(told.back()->joints, (std::vector<int>{4, 7}));
  actions[4]->trigger();
  EXPECT_EQ(told.back()->joints, (std::vector<int>{7}));
}

const std::vector<QString> kNames = {"root", "lfoot", "rfoot"};
const std::vector<ContactSpan> kContacts = {{1, 0, 49}, {2, 50, 99}};
const std::vector<SlideFinding> kSlides = {{.span = kContacts[1],
                                            .slid_cm = 3,
                                            .drift_cm = 2.5,
                                            .worst_speed_cm_s = 40,
                                            .worst_frame = 70}};

TEST(SlideModel, ListsFindingsCountingFramesFromOne) {
  SlideModel model;
  const QAbstractItemModelTester tester(&model);
  model.setFindings(kSlides, kNames);
  ASSERT_EQ(model.rowCount(), 1);
  const auto text = [&](int column) {
    return model.data(model.index(0, column), Qt::DisplayRole).toString();
  };
  EXPECT_EQ(text(SlideModel::Joint), "rfoot");
  EXPECT_EQ(text(SlideModel::Frames), QStringLiteral("51–100"));
  EXPECT_EQ(text(SlideModel::Drift), QStringLiteral("2.50 cm"));
  EXPECT_EQ(text(SlideModel::Slid), QStringLiteral("+3.00 cm"));
}

TEST(FootskatePanel, AClickOnAFindingSeeksToItsWorstFrame) {
  SlideModel model;
  FootskatePanel panel(&model);
  model.setFindings(kSlides, kNames);
  QSignalSpy chosen(&panel, &FootskatePanel::findingChosen);
  panel.resize(300, 300);
  panel.show();
  auto* view = panel.findChild<QTreeView*>();
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                    view->visualRect(model.index(0, 0)).center());
  ASSERT_GE(chosen.count(), 1);
  EXPECT_EQ(chosen.last().at(0).toInt(), 70);
  EXPECT_EQ(chosen.last().at(1).toInt(), 2);
}

TEST(FootskatePanel, TellsOfNewThresholds) {
  SlideModel model;
  FootskatePanel panel(&model);
  ContactSettings told;
  QObject::connect(&panel, &FootskatePanel::settingsChanged,
                   [&](const ContactSettings& settings) { told = settings; });
  panel.findChildren<QDoubleSpinBox*>().at(0)->setValue(7);
  EXPECT_EQ(told.begin_height, 7);
  EXPECT_EQ(told.end_speed, ContactSettings().end_speed);
}

TEST(ContactStrip, DrawsALaneAFootAndTheSlideInAnotherColour) {
  ContactStrip strip;
  strip.setContacts(kContacts, kNames, 100);
  strip.setFindings(kSlides);
  strip.resize(400, strip.sizeHint().height());
  const QImage picture = strip.grab().toImage();
  const auto count = [&](const QColor& colour, int first_row, int last_row) {
    int pixels = 0;
    for (int y = first_row; y < last_row; ++y)
      for (int x = 0; x < picture.width(); ++x)
        pixels += picture.pixelColor(x, y).rgb() == colour.rgb();
    return pixels;
  };
  const int middle = picture.height() / 2;
  EXPECT_GT(count(slideColour(0), 0, middle), 500);
  EXPECT_EQ(count(slideColour(3), 0, middle), 0);
  EXPECT_GT(count(slideColour(3), middle, picture.height()), 500);
}

TEST(ContactStrip, AClickSeeks) {
  ContactStrip strip;
  strip.setContacts(kContacts, kNames, 100);
  strip.resize(400, strip.sizeHint().height());
  QSignalSpy seek(&strip, &ContactStrip::seekRequested);
  QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(strip.width() - 10, 5));
  ASSERT_EQ(seek.count(), 1);
  EXPECT_GE(seek.last().at(0).toInt(), 95);
}

TEST(ContactStrip, IsHiddenWhereNoFootStands) {
  ContactStrip strip;
  strip.setContacts({}, kNames, 100);
  EXPECT_TRUE(strip.isHidden());
}

TEST(SlideColour, GrowsWithTheSlideAndStopsAtTheWorst) {
  EXPECT_EQ(slideSeverity(0), 0);
  EXPECT_EQ(slideSeverity(50), 1);
  float before = 0;
  for (double cm = 0.15; cm < 2; cm += 0.1) {
    EXPECT_GT(slideSeverity(cm), before);
    before = slideSeverity(cm);
  }
}

TEST(SlideMarks, AlertTheJointWhileItSlides) {
  EXPECT_EQ(slideAlerts(kSlides, 3, 49), (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(slideAlerts(kSlides, 3, 50), (std::vector<float>{0, 0, 1}));
}

TEST(SlideMarks, TrailLeadsFromWhereTheSlideBeginsToItsEnd) {
  Eigen::MatrixXd tracks = Eigen::MatrixXd::Zero(100, 9);
  tracks.col(6) = Eigen::VectorXd::LinSpaced(100, 0, 99);
  tracks.col(7).setConstant(5);
  const std::vector<Capsule> trail = slideTrails(kSlides, tracks, 1);
  ASSERT_FALSE(trail.empty());
  EXPECT_EQ(trail.front().start, QVector3D(50, 0, 0));
  EXPECT_EQ(trail.back().end, QVector3D(99, 0, 0));
  for (std::size_t i = 1; i < trail.size(); ++i) EXPECT_EQ(trail[i].start, trail[i - 1].end);
}

}  // namespace
}  // namespace mocapress
