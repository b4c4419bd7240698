// SPDX-License-Identifier: MIT
#include "core/codec/difference_fit.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/select/truncation.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr int kFrames = 200;

Clip three_signals() {
  const Clip clip = test::smooth_motion(kFrames).clip;
  return {clip.sample_rate_hz, clip.channels.leftCols(3)};
}

std::vector<FitWeights> weights_with(double step) {
  FitWeights weights{Eigen::VectorXd::Ones(kFrames), Eigen::VectorXd::Zero(kFrames)};
  weights.place.segment(60, 40).setConstant(4);
  weights.step.segment(60, 40).setConstant(step);
  return {weights, weights, weights};
}

Eigen::MatrixXd error_of(const RankedCoefficients& ranked, const Kept& kept, const Clip& original) {
  Eigen::MatrixXd error = -original.channels;
  for (int s = 0; s < ranked.channels(); ++s)
    error.col(s) += synthesise(ranked, s, 0, kept[static_cast<std::size_t>(s)]);
  return error;
}

double cost_of(const Eigen::MatrixXd& error, const FitWeights& weights) {
  double cost = 0;
  for (const auto& column : error.colwise()) {
    cost += column.cwiseAbs2().dot(weights.place);
    const Eigen::VectorXd steps = column.tail(kFrames - 1) - column.head(kFrames - 1);
    cost += steps.cwiseAbs2().dot(weights.step.tail(kFrames - 1));
  }
  return cost;
}

TEST(DifferenceFit, KeepsAsManyAsAsked) {
  for (const int count : {0, 1, 30, 3 * kFrames}) {
    const CoefficientFit fit =
        fit_coefficients(three_signals(), weights_with(100), Basis::Cubic, count);
    EXPECT_EQ(std::accumulate(fit.kept.begin(), fit.kept.end(), 0), count);
  }
}

TEST(DifferenceFit, CostsLessThanTheLargestCoefficients) {
  const Clip clip = three_signals();
  const RankedCoefficients ranked = rank_coefficients(clip, Basis::Cubic);
  for (const double step : {0.0, 100.0})
    for (const int count : {20, 60}) {
      const auto weights = weights_with(step);
      const CoefficientFit fit = fit_coefficients(clip, weights, Basis::Cubic, count);
      const Kept largest = StandardOrder(ranked, std::vector<double>(3, 1.0)).keep(count);
      EXPECT_LT(cost_of(error_of(fit.ranked, fit.kept, clip), weights[0]),
                0.8 * cost_of(error_of(ranked, largest, clip), weights[0]))
          << step << " " << count;
    }
}

TEST(DifferenceFit, OfEveryCoefficientIsExact) {
  const Clip clip = three_signals();
  const CoefficientFit fit = fit_coefficients(clip, weights_with(0), Basis::Cubic, 3 * kFrames);
  EXPECT_LT(error_of(fit.ranked, fit.kept, clip).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(DifferenceFit, WeighingStepsMakesThemSmaller) {
  const Clip clip = three_signals();
  const auto slid = [&](double step) {
    const CoefficientFit fit = fit_coefficients(clip, weights_with(step), Basis::Cubic, 30);
    const Eigen::MatrixXd standing = error_of(fit.ranked, fit.kept, clip).middleRows(60, 40);
    return (standing.bottomRows(39) - standing.topRows(39)).norm();
  };
  EXPECT_LT(slid(1000), 0.7 * slid(0));
}

TEST(DifferenceFit, OfNoFramesIsNothing) {
  const FitWeights none{Eigen::VectorXd(0), Eigen::VectorXd(0)};
  const CoefficientFit fit =
      fit_coefficients({120, Eigen::MatrixXd(0, 3)}, {none, none, none}, Basis::Cubic, 0);
  EXPECT_EQ(fit.kept, Kept({0, 0, 0}));
}

}  // namespace
}  // namespace mocapress
