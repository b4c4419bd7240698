// SPDX-License-Identifier: MIT
#include "core/metrics/blind_test.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

namespace mocapress {
namespace {

constexpr double kBeyond = 4;  // factor by which the grid reaches beyond the levels

}  // namespace

double PsychometricCurve::right(double level) const {
  const double seen = 1 / (1 + std::exp(-slope * std::log(level / threshold)));
  return kGuessed + (1 - kGuessed - kLapses) * seen;
}

ThresholdGrid::ThresholdGrid(double least, double most) {
  constexpr int kThresholds = 121;
  constexpr int kSlopes = 9;
  constexpr double kLeastSlope = 1;
  constexpr double kMostSlope = 16;
  thresholds_ =
      Eigen::ArrayXd::LinSpaced(kThresholds, std::log(least / kBeyond), std::log(most * kBeyond));
  slopes_ = Eigen::ArrayXd::LinSpaced(kSlopes, std::log(kLeastSlope), std::log(kMostSlope));
  likelihood_ = Eigen::ArrayXXd::Zero(kThresholds, kSlopes);
}

void ThresholdGrid::add(const BlindAnswer& answer) {
  for (Eigen::Index s = 0; s < slopes_.size(); ++s)
    for (Eigen::Index t = 0; t < thresholds_.size(); ++t) {
      const PsychometricCurve curve{std::exp(thresholds_(t)), std::exp(slopes_(s))};
      const double right = curve.right(answer.level);
      likelihood_(t, s) += std::log(answer.right ? right : 1 - right);
    }
}

ThresholdFit ThresholdGrid::fit() const {
  constexpr double kTail = 0.025;
  Eigen::ArrayXXd shares = (likelihood_ - likelihood_.maxCoeff()).exp();
  shares /= shares.sum();
  const Eigen::ArrayXd of_thresholds = shares.rowwise().sum();
  const Eigen::ArrayXd of_slopes = shares.colwise().sum().transpose();
  ThresholdFit fit;
  fit.curve = {std::exp((of_thresholds * thresholds_).sum()),
               std::exp((of_slopes * slopes_).sum())};
  Eigen::Index low = 0;
  for (double below = of_thresholds(0); below < kTail;) below += of_thresholds(++low);
  Eigen::Index high = thresholds_.size() - 1;
  for (double above = of_thresholds(high); above < kTail;) above += of_thresholds(--high);
  fit.low = std::exp(thresholds_(low));
  fit.high = std::exp(thresholds_(high));
  // The grid's ends are far beyond the levels, where nothing was asked: an interval that reaches
  // them is no result.
  const double margin = std::log(kBeyond) / 4;
  fit.found = thresholds_(low) > thresholds_(0) + margin &&
              thresholds_(high) < thresholds_(thresholds_.size() - 1) - margin;
  return fit;
}

ThresholdFit fit_threshold(std::span<const BlindAnswer> answers, double least, double most) {
  ThresholdGrid grid(least, most);
  for (const BlindAnswer& answer : answers) grid.add(answer);
  return grid.fit();
}

double p_by_guessing(int right, int answers) {
  double p = 0;
  for (int k = std::max(right, 0); k <= answers; ++k)
    p += std::exp(std::lgamma(answers + 1) - std::lgamma(k + 1) - std::lgamma(answers - k + 1) -
                  answers * std::log(2));
  return std::min(p, 1.0);
}

BlindTest::BlindTest(std::vector<double> levels, std::uint64_t seed, int questions)
    : levels_(std::move(levels)),
      grid_(levels_.front(), levels_.back()),
      random_(seed),
      questions_(questions) {
  ask();
}

/// Asks for the largest error first, so that the viewer learns what to look for. Later questions
/// are at the level nearest to the threshold estimated so far or, so that the slope can be
/// estimated, at one beside it.
void BlindTest::ask() {
  question_.x_is_b = random_.below(2) == 1;
  const auto last = static_cast<int>(std::ssize(levels_)) - 1;
  if (answers_.empty()) {
    question_.level = last;
    return;
  }
  const double wanted = std::log(fit().curve.threshold);
  const auto nearest = std::ranges::min_element(levels_, [&](double a, double b) {
    return std::abs(std::log(a) - wanted) < std::abs(std::log(b) - wanted);
  });
  const int beside = static_cast<int>(random_.below(3)) - 1;
  question_.level = std::clamp(static_cast<int>(nearest - levels_.begin()) + beside, 0, last);
}

bool BlindTest::answer(bool x_is_b) {
  const bool right = x_is_b == question_.x_is_b;
  answers_.push_back({levels_[question_.level], right});
  grid_.add(answers_.back());
  ask();
  return right;
}

int BlindTest::right() const {
  return static_cast<int>(
      std::ranges::count_if(answers_, [](const BlindAnswer& answer) { return answer.right; }));
}

}  // namespace mocapress
