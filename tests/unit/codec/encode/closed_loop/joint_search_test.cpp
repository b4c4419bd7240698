// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/joint_search.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "core/base/random.h"

namespace mocapress {
namespace {

/// As if it were so many steps from zero, and each took so many bits.
std::array<float, 3> price_of_steps(int steps, float of_step) {
  const auto price = [&](int by) { return of_step * static_cast<float>(std::abs(steps + by)); };
  return {price(-1), price(0), price(1)};
}

/// With the rows that a search wants.
Eigen::MatrixXf with_rows(const Eigen::MatrixXf& cross) {
  Eigen::MatrixXf longer = Eigen::MatrixXf::Zero(JointSearch::rows_for(cross.rows()), cross.cols());
  longer.topRows(cross.rows()) = cross;
  return longer;
}

TEST(JointSearch, LeavesCoefficientsAtTheirBestValuesAlone) {
  const Eigen::MatrixXf cross = with_rows(Eigen::MatrixXf::Identity(3, 3));
  const std::vector<JointSearch::Coefficient> coefficients = {
      {0, 1, price_of_steps(0, 0.1F)},
      {0.1F, 1, price_of_steps(2, 0.01F)},
      {-0.2F, 1, price_of_steps(-1, 0.01F)}};
  EXPECT_EQ(JointSearch(coefficients, cross).run(), (std::vector{0, 0, 0}));
}

TEST(JointSearch, FindsAGainThatNeedsThreeMovesMore) {
  // One that moves all that the other three move, which are zero.
  Eigen::MatrixXf cross(4, 4);
  cross << 3, 1, 1, 1,  //
      1, 1, 0, 0,       //
      1, 0, 1, 0,       //
      1, 0, 0, 1;
  const std::vector<JointSearch::Coefficient> coefficients = {{0, 3, price_of_steps(3, 2)},
                                                              {0, 1, price_of_steps(-1, 0.5F)},
                                                              {0, 1, price_of_steps(-1, 0.5F)},
                                                              {0, 1, price_of_steps(-1, 0.5F)}};
  const Eigen::MatrixXf longer = with_rows(cross);
  EXPECT_EQ(JointSearch(coefficients, longer).run(), (std::vector{-1, 1, 1, 1}));
}

TEST(JointSearch, NeverRaisesTheCost) {
  Random random(3);
  int moved = 0;
  for (int i = 0; i < 200; ++i) {
    constexpr int kCount = 6;
    Eigen::MatrixXf parts(8, kCount);
    for (float& part : parts.reshaped()) part = static_cast<float>(random.unit() - 0.5);
    const Eigen::MatrixXf cross = parts.transpose() * parts;
    std::vector<JointSearch::Coefficient> coefficients;
    for (int c = 0; c < kCount; ++c)
      coefficients.push_back({static_cast<float>(random.unit() - 0.5), cross(c, c),
                              price_of_steps(static_cast<int>(random.below(5)) - 2, 0.1F)});
    const Eigen::MatrixXf longer = with_rows(cross);
    const std::vector<int> moves = JointSearch(coefficients, longer).run();
    Eigen::VectorXf by(kCount);
    float cost = 0;
    for (int c = 0; c < kCount; ++c) {
      const auto at = static_cast<std::size_t>(c);
      ASSERT_LE(std::abs(moves[at]), 1);
      by(c) = static_cast<float>(moves[at]);
      moved += std::abs(moves[at]);
      cost += 2 * by(c) * coefficients[at].slope +
              coefficients[at].prices[static_cast<std::size_t>(moves[at] + 1)] -
              coefficients[at].prices[1];
    }
    EXPECT_LE(cost + by.dot(cross * by), 1e-5F);
  }
  EXPECT_GT(moved, 200);
}

}  // namespace
}  // namespace mocapress
