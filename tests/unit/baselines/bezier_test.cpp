// SPDX-License-Identifier: MIT
#include "core/baselines/bezier.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace mocapress {
namespace {

TEST(Bezier, FitsCubicsExactly) {
  Eigen::MatrixXd rows(17, 2);
  for (int t = 0; t < 17; ++t) rows.row(t) << 1 + 0.5 * t - 0.1 * t * t, 0.01 * t * t * t - 2.0 * t;
  const Eigen::MatrixXd controls = fit_bezier(rows);
  EXPECT_LT((bezier_curve(rows.row(0), controls, 16) - rows.bottomRows(16)).norm(), 1e-6);
}

TEST(Bezier, KeepsUpToThreeFramesAfterTheStartExactly) {
  Random random(1);
  for (const int steps : {1, 2, 3}) {
    Eigen::MatrixXd rows(steps + 1, 4);
    for (double& value : rows.reshaped()) value = random.unit();
    const Eigen::MatrixXd controls = fit_bezier(rows);
    EXPECT_LT((bezier_curve(rows.row(0), controls, steps) - rows.bottomRows(steps)).norm(), 1e-6);
  }
}

TEST(Bezier, NoOtherInnerControlPointsComeNearer) {
  Random random(2);
  Eigen::MatrixXd rows(21, 1);
  for (double& value : rows.reshaped()) value = random.unit();
  const Eigen::MatrixXd controls = fit_bezier(rows);
  const auto error = [&](const Eigen::MatrixXd& of) {
    return (bezier_curve(rows.row(0), of, 20) - rows.bottomRows(20)).squaredNorm();
  };
  for (int point : {0, 1})
    for (const double change : {-1e-2, 1e-2}) {
      Eigen::MatrixXd other = controls;
      other(point, 0) += change;
      EXPECT_GT(error(other), error(controls));
    }
  EXPECT_EQ(controls(2, 0), rows(20, 0)) << "the end is kept";
}

}  // namespace
}  // namespace mocapress
