// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/importance_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>

#include "resources/samples/generator/samples.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/factor_control.h"

namespace mocapress {
namespace {

class ImportancePanelTest : public testing::Test {
 protected:
  ImportancePanelTest() {
    panel_.setSkeleton(skeleton_);
    QObject::connect(&panel_, &ImportancePanel::importanceChanged,
                     [this](const Importance& importance) { told_.push_back(importance); });
  }

  double factorOf(const Importance& importance, int joint) const {
    return importance.joints.at(static_cast<std::size_t>(joint));
  }

  const Skeleton skeleton_ = samples::walk_clip().skeleton;
  const std::vector<int> feet_ = joints_of(skeleton_, BodyPart::Feet);
  ImportancePanel panel_;
  std::vector<Importance> told_;
};

TEST_F(ImportancePanelTest, ASliderIsTheFactorOfAllJointsOfItsPart) {
  panel_.part(BodyPart::Feet)->slider()->setValue(750);
  ASSERT_EQ(told_.size(), 1u);
  for (int j = 0; j < skeleton_.joint_count(); ++j) {
    const bool foot = std::count(feet_.begin(), feet_.end(), j) > 0;
    EXPECT_DOUBLE_EQ(factorOf(told_[0], j), foot ? 4 : 1) << j;
  }
  EXPECT_DOUBLE_EQ(panel_.part(BodyPart::Feet)->number()->value(), 4);
  panel_.part(BodyPart::Feet)->slider()->setValue(505);  // snaps to the middle
  EXPECT_TRUE(told_.back().is_even());
}

TEST_F(ImportancePanelTest, EmitsNothingWhenSetByTheProgram) {
  Importance importance{
      .joints = std::vector<double>(static_cast<std::size_t>(skeleton_.joint_count()), 1.0),
      .contacts = 20};
  for (const int joint : feet_) importance.joints[static_cast<std::size_t>(joint)] = 2;
  panel_.setImportance(importance);
  EXPECT_TRUE(told_.empty());
  EXPECT_EQ(panel_.part(BodyPart::Feet)->value(), 2);
  EXPECT_EQ(panel_.part(BodyPart::Head)->value(), 1);
  EXPECT_EQ(panel_.contacts()->value(), 20);
}

TEST_F(ImportancePanelTest, ADrawerHoldsAnyJoint) {
  EXPECT_FALSE(panel_.joints()->isVisibleTo(&panel_));
  panel_.drawer()->click();
  EXPECT_TRUE(panel_.joints()->isVisibleTo(&panel_));
  ASSERT_EQ(panel_.joints()->topLevelItemCount(), skeleton_.joint_count());
  const int joint = feet_[0];
  panel_.joints()->topLevelItem(joint)->setData(1, Qt::EditRole, 8.0);
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(factorOf(told_[0], joint), 8);
  EXPECT_EQ(panel_.part(BodyPart::Feet)->value(), 1) << "most of its joints";
  panel_.joints()->topLevelItem(joint)->setData(1, Qt::EditRole, -3.0);
  EXPECT_EQ(factorOf(told_.back(), joint), 0);
  panel_.finder()->setText(QString::fromStdString(skeleton_.joint(joint).name));
  EXPECT_TRUE(panel_.joints()->topLevelItem(0)->isHidden());
  EXPECT_FALSE(panel_.joints()->topLevelItem(joint)->isHidden());
}

TEST_F(ImportancePanelTest, AButtonMakesAllImportancesEqual) {
  panel_.contacts()->number()->setValue(20);
  panel_.part(BodyPart::Head)->number()->setValue(3);
  EXPECT_FALSE(told_.back().is_even());
  panel_.even()->click();
  EXPECT_TRUE(told_.back().is_even());
}

TEST_F(ImportancePanelTest, IsDisabledAndSaysWhyWhereTheMethodHeedsNone) {
  for (const Method method : {Method::Standard, Method::PerChannel}) {
    panel_.setMethod(method);
    EXPECT_FALSE(panel_.contacts()->isEnabled());
    EXPECT_FALSE(panel_.part(BodyPart::Feet)->isEnabled());
  }
  panel_.setMethod(Method::Annealed);
  EXPECT_TRUE(panel_.contacts()->isEnabled());
}

TEST_F(ImportancePanelTest, APartThatTheSkeletonLacksCannotBeChosen) {
  Skeleton bare;
  bare.add({.name = "root"});
  panel_.setSkeleton(bare);
  EXPECT_FALSE(panel_.part(BodyPart::Fingers)->isEnabled());
  EXPECT_TRUE(panel_.contacts()->isEnabled());
}

TEST(CompressionPanelMethods, DisablesControlsThatDoNotApplyAndSaysWhy) {
  CompressionPanel panel;
  struct Case {
    Method method;
    bool effort, coding, importance;
  };
  for (const Case& each :
       {Case{Method::ClosedLoop, true, false, true}, Case{Method::Annealed, false, true, true},
        Case{Method::Standard, false, true, false}, Case{Method::PerChannel, false, true, false}}) {
    EncodeSettings options;
    options.method = each.method;
    panel.setOptions(options);
    EXPECT_EQ(panel.effort()->isEnabled(), each.effort) << name(each.method);
    EXPECT_EQ(panel.coding()->isEnabled(), each.coding) << name(each.method);
    EXPECT_EQ(panel.importance()->isEnabled(), each.importance) << name(each.method);
  }
  EncodeSettings options;
  options.method = Method::ClosedLoop;
  panel.setOptions(options);
  const QString why = panel.coding()->toolTip();
  options.method = Method::Annealed;
  panel.setOptions(options);
  EXPECT_NE(panel.coding()->toolTip(), why);
}

TEST(CompressionPanelMethods, TheCodingOfAClassicMethodOutlivesTheClosedLoop) {
  CompressionPanel panel;
  EncodeSettings told;
  QObject::connect(&panel, &CompressionPanel::optionsChanged,
                   [&](const EncodeSettings& options) { told = options; });
  panel.setOptions({.method = Method::Annealed, .coding = Coding::Rle16});
  for (const Method method : {Method::ClosedLoop, Method::Annealed}) {
    const int index = panel.method()->findData(static_cast<int>(method));
    panel.method()->setCurrentIndex(index);
    emit panel.method()->activated(index);
    EXPECT_EQ(told.method, method);
  }
  EXPECT_EQ(told.coding, Coding::Rle16);
}

}  // namespace
}  // namespace mocapress
