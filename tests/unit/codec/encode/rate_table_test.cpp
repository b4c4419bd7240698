// SPDX-License-Identifier: MIT
#include "core/codec/encode/rate_table.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace mocapress {
namespace {

TEST(RateTable, ADifferenceAroundACoefficientIsThatOfTheWholeSignal) {
  const Lifting lifting(Basis::Cubic, 150);
  Random random(4);
  Eigen::MatrixXi values(150, 2);
  for (int& value : values.reshaped()) value = static_cast<int>(random.below(5)) - 2;
  const RateTable table(lifting.bands());
  int* const signal = values.col(1).data();
  for (std::size_t b = 1; b < lifting.bands().size(); ++b)
    for (int i = 0; i < lifting.bands()[b].size; ++i) {
      int& value = signal[lifting.bands()[b].first + i];
      const int other = value == 3 ? 1 : 3;
      const RateTable::Around around_it(table, signal, static_cast<int>(b), i);
      const double around = around_it.bits(other) - around_it.bits(value);
      const double before = table.bits(signal);
      const int kept = std::exchange(value, other);
      EXPECT_NEAR(table.bits(signal) - before, around, 1e-9);
      value = kept;
    }
}

TEST(RateTable, ZerosAmongZerosAreCheap) {
  const Lifting lifting(Basis::Cubic, 300);
  Eigen::MatrixXi values = Eigen::MatrixXi::Zero(300, 1);
  for (int c = 150; c < 300; c += 10) values(c, 0) = 1;
  const RateTable table(lifting.bands());
  const int finest = static_cast<int>(lifting.bands().size()) - 1;
  EXPECT_LT(table.bits(values.data(), finest, 5, 0), 0.5);
  EXPECT_GT(table.bits(values.data(), finest, 5, 7), table.bits(values.data(), finest, 5, 1));
}

}  // namespace
}  // namespace mocapress
