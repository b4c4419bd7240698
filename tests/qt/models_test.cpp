// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSet>
#include <QSignalSpy>
#include <QSortFilterProxyModel>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"
#include "widgets/models/curve_selection.h"
#include "widgets/models/joint_error_model.h"
#include "widgets/models/log_scale.h"

namespace mocapress {
namespace {

TEST(LogScale, PositionAndValueAreInverse) {
  const LogScale scale{2, 200};
  for (int position = 0; position <= scale.steps; ++position)
    EXPECT_EQ(scale.position(scale.value(position)), position);
  EXPECT_DOUBLE_EQ(scale.value(0), 2);
  EXPECT_NEAR(scale.value(scale.steps), 200, 1e-9);
  EXPECT_NEAR(scale.value(500), 20, 1e-9);
}

TEST(LogScale, ChosenValuesHaveThreeDigits) {
  EXPECT_DOUBLE_EQ(in_three_digits(36.885), 36.9);
  EXPECT_DOUBLE_EQ(in_three_digits(1.002305), 1);
  EXPECT_DOUBLE_EQ(in_three_digits(0.0123456), 0.0123);
  EXPECT_DOUBLE_EQ(in_three_digits(123456), 123000);
}

TEST(LogScale, ValuesOutsideTakeTheEnds) {
  const LogScale scale{2, 200};
  EXPECT_EQ(scale.position(1), 0);
  EXPECT_EQ(scale.position(1000), scale.steps);
}

TEST(CurveSelection, KeepsEachColourWhileOthersComeAndGo) {
  CurveSelection curves;
  for (const char* name : {"a", "b", "c"}) curves.add(QString::fromLatin1(name));
  const QColor c = curves.colour(QStringLiteral("c"));
  const QColor a = curves.colour(QStringLiteral("a"));
  curves.remove(QStringLiteral("a"));
  EXPECT_EQ(curves.colour(QStringLiteral("c")), c);
  curves.add(QStringLiteral("d"));
  EXPECT_EQ(curves.colour(QStringLiteral("d")), a);
  EXPECT_EQ(curves.names().size(), 3);
}

TEST(CurveSelection, ColoursOfUpToSevenCurvesDiffer) {
  CurveSelection curves;
  QSet<QRgb> colours;
  for (int i = 0; i < 7; ++i) {
    curves.add(QString::number(i));
    colours << curves.colour(QString::number(i)).rgb();
  }
  EXPECT_EQ(colours.size(), 7);
}

TEST(CurveSelection, DoesNotContainTheEmptyName) {
  CurveSelection curves;
  curves.add(QStringLiteral("a"));
  curves.remove(QStringLiteral("a"));
  EXPECT_FALSE(curves.contains(QString()));
  EXPECT_TRUE(curves.names().isEmpty());
}

class JointErrors : public testing::Test {
 protected:
  JointErrors() : points_(landmarks(test::small_skeleton())) {}

  QVariant at(int row, int column, int role = Qt::DisplayRole) const {
    return model_.data(model_.index(row, column), role);
  }

  std::vector<Landmark> points_;
  JointErrorModel model_;
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(JointErrors, ShowsEveryLandmarkWithItsMeanAndMax) {
  model_.setLandmarks(points_);
  EXPECT_EQ(model_.rowCount(), static_cast<int>(points_.size()));
  EXPECT_EQ(at(0, JointErrorModel::Mean).toString(), QStringLiteral("–"));
  Distortion errors{.distances = Eigen::MatrixXf::Zero(4, model_.rowCount())};
  errors.distances.col(2) << 0, 1, 2, 5;
  model_.setErrors(&errors, nullptr);
  EXPECT_DOUBLE_EQ(at(2, JointErrorModel::Mean, JointErrorModel::kSortRole).toDouble(), 2);
  EXPECT_DOUBLE_EQ(at(2, JointErrorModel::Max, JointErrorModel::kSortRole).toDouble(), 5);
  EXPECT_EQ(at(0, JointErrorModel::Name).toString(), QStringLiteral("root"));
  model_.setErrors(nullptr, nullptr);
  EXPECT_EQ(at(2, JointErrorModel::Max).toString(), QStringLiteral("–"));
}

TEST_F(JointErrors, NamesJointsWithoutTheNamespaceTheyShare) {
  for (Landmark& point : points_) point.name = "mixamorig:" + point.name;
  model_.setLandmarks(points_, "mixamorig:");
  EXPECT_EQ(at(0, JointErrorModel::Name).toString(), QStringLiteral("root"));
  EXPECT_EQ(at(0, JointErrorModel::Name, Qt::ToolTipRole).toString(),
            QStringLiteral("mixamorig:root"));
  const QSignalSpy wishes(&model_, &JointErrorModel::checkRequested);
  model_.setData(model_.index(0, JointErrorModel::Name), Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(wishes[0][0].toString(), QStringLiteral("mixamorig:root"));
}

TEST_F(JointErrors, ShowsTheAngleOfEveryJointAndItsEnds) {
  model_.setLandmarks(points_);
  const int joints = test::small_skeleton().joint_count();
  Distortion errors{.distances = Eigen::MatrixXf::Zero(4, model_.rowCount()),
                    .joint_degrees = Eigen::VectorXd::LinSpaced(joints, 0, joints - 1)};
  EXPECT_EQ(at(2, JointErrorModel::Angle).toString(), QStringLiteral("–"));
  model_.setErrors(&errors, nullptr);
  EXPECT_EQ(at(2, JointErrorModel::Angle).toString(), QStringLiteral("2.0°"));
  for (int row = 0; row < model_.rowCount(); ++row)
    EXPECT_EQ(at(row, JointErrorModel::Angle, JointErrorModel::kSortRole).toInt(),
              points_[static_cast<std::size_t>(row)].joint);
  EXPECT_TRUE(model_.headerData(JointErrorModel::Angle, Qt::Horizontal, Qt::ToolTipRole)
                  .toString()
                  .contains(QStringLiteral("world-space rotation")));
}

TEST_F(JointErrors, ShowsTheWorstVisibilityOfEveryJoint) {
  model_.setLandmarks(points_);
  SightTable sight;
  sight.times_noticed.setZero(3, test::small_skeleton().joint_count());
  sight.times_noticed(1, 2) = 1.44F;
  EXPECT_EQ(at(2, JointErrorModel::Seen).toString(), QStringLiteral("–"));
  model_.setErrors(nullptr, &sight);
  EXPECT_EQ(at(2, JointErrorModel::Seen).toString(), QStringLiteral("1.44×"));
  EXPECT_EQ(at(2, JointErrorModel::Seen, Qt::ToolTipRole).toString(), QStringLiteral("borderline"));
  EXPECT_EQ(at(0, JointErrorModel::Seen).toString(), QStringLiteral("0.00×"));
}

TEST_F(JointErrors, SortsByError) {
  model_.setLandmarks(points_);
  Distortion errors{.distances = Eigen::MatrixXf::Zero(1, model_.rowCount())};
  errors.distances(0, 3) = 10.5F;
  errors.distances(0, 5) = 9;
  model_.setErrors(&errors, nullptr);
  QSortFilterProxyModel sorted;
  sorted.setSourceModel(&model_);
  sorted.setSortRole(JointErrorModel::kSortRole);
  sorted.sort(JointErrorModel::Mean, Qt::DescendingOrder);
  EXPECT_EQ(sorted.mapToSource(sorted.index(0, 0)).row(), 3);
  EXPECT_EQ(sorted.mapToSource(sorted.index(1, 0)).row(), 5);
}

TEST_F(JointErrors, ACheckOnlyAsksTheOwnerForASelection) {
  model_.setLandmarks(points_);
  const QSignalSpy wishes(&model_, &JointErrorModel::checkRequested);
  const QModelIndex root = model_.index(0, JointErrorModel::Name);
  EXPECT_TRUE(model_.setData(root, Qt::Checked, Qt::CheckStateRole));
  ASSERT_EQ(wishes.count(), 1);
  EXPECT_EQ(wishes[0][0].toString(), QStringLiteral("root"));
  EXPECT_TRUE(wishes[0][1].toBool());
  EXPECT_EQ(at(0, 0, Qt::CheckStateRole).toInt(), Qt::Unchecked);
  CurveSelection curves;
  curves.add(QStringLiteral("root"));
  model_.setSelection(curves);
  EXPECT_EQ(at(0, 0, Qt::CheckStateRole).toInt(), Qt::Checked);
}

}  // namespace
}  // namespace mocapress
