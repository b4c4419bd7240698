// SPDX-License-Identifier: MIT
#include "core/baselines/k_means.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/random.h"

namespace mocapress {
namespace {

TEST(KMeans, FindsGroupsThatAreFarApart) {
  Random random(1);
  Eigen::MatrixXd rows(90, 2);
  for (int r = 0; r < 90; ++r)
    rows.row(r) << 100 * (r / 30) + random.unit(), -50 * (r / 30) + random.unit();
  const std::vector<int> clusters = k_means(rows, 3);
  for (std::size_t r = 0; r < 90; ++r) EXPECT_EQ(clusters[r], clusters[r / 30 * 30]) << r;
  EXPECT_EQ(std::set(clusters.begin(), clusters.end()).size(), 3u);
}

TEST(KMeans, NoRowIsNearerToTheMeanOfAnotherCluster) {
  Random random(2);
  Eigen::MatrixXd rows(60, 3);
  for (double& value : rows.reshaped()) value = random.unit();
  const std::vector<int> clusters = k_means(rows, 4);
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(4, 3);
  Eigen::Vector4d counts = Eigen::Vector4d::Zero();
  for (int r = 0; r < 60; ++r) {
    means.row(clusters[static_cast<std::size_t>(r)]) += rows.row(r);
    counts(clusters[static_cast<std::size_t>(r)]) += 1;
  }
  means.array().colwise() /= counts.array();
  for (int r = 0; r < 60; ++r) {
    const double own = (rows.row(r) - means.row(clusters[static_cast<std::size_t>(r)])).norm();
    for (int c = 0; c < 4; ++c) EXPECT_LE(own, (rows.row(r) - means.row(c)).norm() + 1e-9);
  }
}

}  // namespace
}  // namespace mocapress
