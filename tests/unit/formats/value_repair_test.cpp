// SPDX-License-Identifier: MIT
#include "core/formats/value_repair.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace mocapress {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(RepairValues, RepeatsTheFrameBefore) {
  std::vector<double> values = {1, 10, kNan, 20, kInfinity, -1e30, 4, 40};
  EXPECT_EQ(repair_values(RawRows(values.data(), 4, 2)), 3);
  EXPECT_EQ(values, (std::vector<double>{1, 10, 1, 20, 1, 20, 4, 40}));
}

TEST(RepairValues, FillsTheFirstFramesFromTheFirstGoodOne) {
  std::vector<double> values = {kNan, kNan, kNan, kNan, 7, kNan};
  EXPECT_EQ(repair_values(RawRows(values.data(), 3, 2)), 5);
  EXPECT_EQ(values, (std::vector<double>{7, 0, 7, 0, 7, 0}));
}

TEST(RepairValues, LeavesGoodValuesAlone) {
  std::vector<double> values = {0, -3, 1e6, 2};
  const std::vector<double> before = values;
  EXPECT_EQ(repair_values(RawRows(values.data(), 2, 2)), 0);
  EXPECT_EQ(values, before);
}

}  // namespace
}  // namespace mocapress
