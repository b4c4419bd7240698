// SPDX-License-Identifier: MIT
#include "core/codec/encode/mend/difference_fit.h"

#include <gtest/gtest.h>

#include "core/codec/format/quantised_signals.h"
#include "core/select/ranking.h"
#include "tests/support/test_motion.h"

namespace mocapress::difference_fit_test {
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

/// Steps so small that rounding has no effect.
double finest(double) {
  return 1e-5;
}

Eigen::MatrixXd error_of(const RankedCoefficients& ranked, const Kept& kept, const Clip& original) {
  Eigen::MatrixXd error = -original.channels;
  for (int s = 0; s < ranked.channels(); ++s)
    error.col(s) += synthesise(ranked, s, 0, kept[static_cast<std::size_t>(s)]);
  return error;
}

Eigen::MatrixXd error_of(const Eigen::MatrixXi& values, const Eigen::VectorXd& steps,
                         const Clip& original) {
  const Lifting lifting(Basis::Cubic, original.frames());
  const std::vector<double> gains = lifting.gains();
  Eigen::MatrixXd samples = values.cast<double>() * steps.asDiagonal();
  samples.array().colwise() /= Eigen::Map<const Eigen::ArrayXd>(gains.data(), std::ssize(gains));
  for (auto column : samples.colwise()) {
    const std::span<double> signal(column.data(), static_cast<std::size_t>(column.size()));
    lifting.inverse(signal, signal);
  }
  return samples - original.channels;
}

Eigen::MatrixXd error_of(const DifferenceFit& fit, const Clip& original) {
  return error_of(fit.values, fit.steps, original);
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
    const DifferenceFit fit =
        fit_differences(three_signals(), weights_with(100), Basis::Cubic, count, finest);
    EXPECT_EQ(fit.kept.count(), count);
    EXPECT_TRUE((fit.kept || fit.values.array() == 0).all());
  }
}

TEST(DifferenceFit, CostsLessThanTheLargestCoefficients) {
  const Clip clip = three_signals();
  const RankedCoefficients ranked = rank_coefficients(clip, Basis::Cubic);
  for (const double step : {0.0, 100.0})
    for (const int count : {20, 60}) {
      const auto weights = weights_with(step);
      const DifferenceFit fit = fit_differences(clip, weights, Basis::Cubic, count, finest);
      const Kept largest = StandardOrder(ranked, std::vector<double>(3, 1.0)).keep(count);
      EXPECT_LT(cost_of(error_of(fit, clip), weights[0]),
                0.8 * cost_of(error_of(ranked, largest, clip), weights[0]))
          << step << " " << count;
    }
}

TEST(DifferenceFit, IsExactWithEveryCoefficient) {
  const Clip clip = three_signals();
  const DifferenceFit fit =
      fit_differences(clip, weights_with(0), Basis::Cubic, 3 * kFrames, finest);
  EXPECT_LT(error_of(fit, clip).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(DifferenceFit, WeighingStepsMakesThemSmaller) {
  const Clip clip = three_signals();
  const auto slid = [&](double step) {
    const DifferenceFit fit = fit_differences(clip, weights_with(step), Basis::Cubic, 30, finest);
    const Eigen::MatrixXd standing = error_of(fit, clip).middleRows(60, 40);
    return (standing.bottomRows(39) - standing.topRows(39)).norm();
  };
  EXPECT_LT(slid(1000), 0.7 * slid(0));
}

TEST(DifferenceFit, RoundsToStepsThatCostLittleBesideWhatIsDropped) {
  const Clip clip = three_signals();
  for (const int count : {20, 60, 200}) {
    const auto weights = weights_with(100);
    const auto cost_with = [&](const CodedStep& step) {
      return cost_of(error_of(fit_differences(clip, weights, Basis::Cubic, count, step), clip),
                     weights[0]);
    };
    EXPECT_LT(cost_with([](double step) { return step; }), 2 * cost_with(finest)) << count;
  }
}

TEST(DifferenceFit, RoundedTogetherCostsLessThanEachToTheNearest) {
  const Clip clip = three_signals();
  const auto weights = weights_with(100);
  const auto fit_to = [&](double step) {
    return fit_differences(clip, weights, Basis::Cubic, 60, [step](double) { return step; });
  };
  const DifferenceFit fine = fit_to(1e-5);
  const double least = cost_of(error_of(fine, clip), weights[0]);
  for (const double step : {0.5, 2.0, 8.0}) {
    const DifferenceFit together = fit_to(step);
    const Eigen::MatrixXi nearest =
        (fine.values.cast<double>() * 1e-5 / step).array().round().cast<int>();
    EXPECT_LT(cost_of(error_of(together, clip), weights[0]) - least,
              0.9 * (cost_of(error_of(nearest, together.steps, clip), weights[0]) - least))
        << step;
  }
}

TEST(DifferenceFit, IsEmptyWithoutFrames) {
  const FitWeights none{Eigen::VectorXd(0), Eigen::VectorXd(0)};
  const DifferenceFit fit =
      fit_differences({120, Eigen::MatrixXd(0, 3)}, {none, none, none}, Basis::Cubic, 0, finest);
  EXPECT_EQ(fit.kept.count(), 0);
  EXPECT_EQ(fit.steps.size(), 3);
}

}  // namespace
}  // namespace mocapress::difference_fit_test
