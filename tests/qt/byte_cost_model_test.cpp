// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/byte_cost_model.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

#include "widgets/panels/bytes_panel.h"

namespace mocapress {
namespace {

std::shared_ptr<const ByteCosts> costs() {
  ByteCosts made{.slice_frames = 10,
                 .bytes = Eigen::MatrixXd(2, 2),
                 .rest = {{"skeleton", 40}, {"section heads", 32}},
                 .file_bytes = 100};
  made.bytes << 4, 10, 2, 12;
  return std::make_shared<const ByteCosts>(std::move(made));
}

TEST(ByteCostModel, ListsJointsThenTheRest) {
  ByteCostModel model;
  model.setCosts(costs(), {QStringLiteral("root"), QStringLiteral("hand")});
  ASSERT_EQ(model.rowCount(), 4);
  const auto text = [&](int row, int column) {
    return model.index(row, column).data(Qt::DisplayRole).toString();
  };
  EXPECT_EQ(text(1, ByteCostModel::Name), QStringLiteral("hand"));
  EXPECT_EQ(text(1, ByteCostModel::Bytes), QStringLiteral("22"));
  EXPECT_EQ(model.index(1, ByteCostModel::Share).data(ByteCostModel::kSortRole).toDouble(), 22);
  EXPECT_EQ(model.jointOf(1), 1);
  EXPECT_EQ(model.jointOf(2), -1);
  model.setCosts(nullptr, {});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(BytesPanel, KeepsTheChosenLineWhenMoreCome) {
  ByteCostModel model;
  BytesPanel panel(&model);
  std::vector<SlopeRow> rows = {{QStringLiteral("Fingers"), -310, 0.2, 0.4}};
  panel.setSlopes(rows);
  panel.slopes()->setCurrentItem(panel.slopes()->topLevelItem(0));
  rows.push_back({QStringLiteral("More"), 90, 1, 0.9});
  panel.setSlopes(rows);
  EXPECT_EQ(panel.slopes()->currentItem(), panel.slopes()->topLevelItem(0));
  EXPECT_TRUE(panel.apply()->isEnabled());
  panel.setSlopes({});
  EXPECT_FALSE(panel.apply()->isEnabled());
}

TEST(BytesPanel, AppliesTheChosenLine) {
  ByteCostModel model;
  BytesPanel panel(&model);
  panel.setSlopes(
      {{QStringLiteral("Fingers"), -310, 0.2, 0.4}, {QStringLiteral("More"), 90, 1, 0.9}});
  EXPECT_FALSE(panel.apply()->isEnabled());
  panel.slopes()->setCurrentItem(panel.slopes()->topLevelItem(1));
  EXPECT_TRUE(panel.apply()->isEnabled());
  QSignalSpy applied(&panel, &BytesPanel::applyRequested);
  panel.apply()->click();
  ASSERT_EQ(applied.count(), 1);
  EXPECT_EQ(applied[0][0].toInt(), 1);
  panel.setState(true, true);
  EXPECT_FALSE(panel.measure()->isEnabled());
}

}  // namespace
}  // namespace mocapress
