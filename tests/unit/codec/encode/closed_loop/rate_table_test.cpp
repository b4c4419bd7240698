// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/rate_table.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "core/base/random.h"

namespace mocapress {
namespace {

TEST(RateTable, ADifferenceAroundACoefficientIsThatOfTheWholeSignal) {
  const Lifting lifting(Basis::Cubic, 150);
  Random random(4);
  Eigen::MatrixXi values(150, 2);
  for (int& value : values.reshaped()) value = static_cast<int>(random.below(5)) - 2;
  values.col(1).segment(90, 30).setZero();  // some are among zeros
  const RateTable table(lifting.bands());
  int* const signal = values.col(1).data();
  Magnitudes magnitudes(lifting.bands());
  magnitudes.read(lifting.bands(), signal);
  for (std::size_t b = 1; b < lifting.bands().size(); ++b)
    for (int i = 0; i < lifting.bands()[b].size; ++i) {
      int& value = signal[lifting.bands()[b].first + i];
      const int other = value == 3 ? 1 : 3;
      const RateTable::Around around_it(table, magnitudes, static_cast<int>(b), i);
      const double around = around_it.bits(other) - around_it.bits(value);
      const double before = table.bits(signal, magnitudes);
      const int kept = std::exchange(value, other);
      magnitudes.set(static_cast<int>(b), i, other);
      EXPECT_NEAR(table.bits(signal, magnitudes) - before, around, 1e-9);
      value = kept;
      magnitudes.set(static_cast<int>(b), i, kept);
    }
}

TEST(RateTable, AStepTowardsZeroSavesNoMoreThanItSays) {
  const Lifting lifting(Basis::Cubic, 200);
  Random random(5);
  const RateTable table(lifting.bands());
  Eigen::VectorXi values(200);
  Magnitudes magnitudes(lifting.bands());
  for (int round = 0; round < 20; ++round) {
    for (int& value : values) value = static_cast<int>(random.below(12)) / (2 + round % 4 * 3);
    magnitudes.read(lifting.bands(), values.data());
    for (int b = 1; b < static_cast<int>(lifting.bands().size()); ++b)
      for (int i = 0; i < lifting.bands()[static_cast<std::size_t>(b)].size; ++i) {
        const RateTable::Around around(table, magnitudes, b, i);
        for (const int value : {1, 2, 3, 15, 16, 40, 300})
          EXPECT_LE(around.bits(value) - around.bits(value - 1), RateTable::kMostSaved);
      }
  }
}

TEST(RateTable, ZerosAmongZerosAreCheap) {
  const Lifting lifting(Basis::Cubic, 300);
  Eigen::MatrixXi values = Eigen::MatrixXi::Zero(300, 1);
  for (int c = 150; c < 300; c += 10) values(c, 0) = 1;
  const RateTable table(lifting.bands());
  Magnitudes magnitudes(lifting.bands());
  magnitudes.read(lifting.bands(), values.data());
  const int finest = static_cast<int>(lifting.bands().size()) - 1;
  EXPECT_LT(table.bits(magnitudes, finest, 5, 0), 0.5);
  EXPECT_GT(table.bits(magnitudes, finest, 5, 7), table.bits(magnitudes, finest, 5, 1));
}

}  // namespace
}  // namespace mocapress
