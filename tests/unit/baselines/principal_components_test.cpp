// SPDX-License-Identifier: MIT
#include "core/baselines/principal_components.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace mocapress {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  Random random(seed);
  Eigen::MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = 2 * random.unit() - 1;
  return matrix;
}

Eigen::MatrixXd restored(const PrincipalComponents& parts, int components) {
  return (parts.projections.leftCols(components) * parts.basis.leftCols(components).transpose())
             .rowwise() +
         parts.mean.transpose();
}

TEST(PrincipalComponents, AllOfThemRestoreTallAndWideMatrices) {
  for (const auto& [rows, columns] : {std::pair{40, 7}, std::pair{7, 40}, std::pair{9, 9}}) {
    const Eigen::MatrixXd matrix = random_matrix(rows, columns, 1);
    const PrincipalComponents parts = principal_components(matrix);
    EXPECT_LE(parts.count(), std::min(rows - 1, columns));
    EXPECT_LT((restored(parts, parts.count()) - matrix).norm(), 1e-10);
    const Eigen::MatrixXd products = parts.basis.transpose() * parts.basis;
    EXPECT_LT((products - Eigen::MatrixXd::Identity(parts.count(), parts.count())).norm(), 1e-9);
  }
}

TEST(PrincipalComponents, AMatrixOfRankTwoHasTwo) {
  const Eigen::MatrixXd matrix = random_matrix(50, 2, 2) * random_matrix(2, 12, 3);
  EXPECT_EQ(principal_components(matrix).count(), 2);
  EXPECT_EQ(principal_components(matrix.transpose()).count(), 2);
}

TEST(PrincipalComponents, EnoughForAnErrorIsTheFewestThatKeepIt) {
  const Eigen::MatrixXd matrix = random_matrix(60, 10, 4);
  const PrincipalComponents parts = principal_components(matrix);
  const auto squared_error = [&](int components) {
    return (restored(parts, components) - matrix).squaredNorm() / 60;
  };
  for (const double allowed : {0.1, 0.5, 1.0, 2.0, 100.0}) {
    const int enough = parts.enough_for(allowed);
    EXPECT_LE(squared_error(enough), allowed);
    if (enough > 0) {
      EXPECT_GT(squared_error(enough - 1), allowed);
    }
  }
  EXPECT_EQ(parts.enough_for(0), parts.count());
}

TEST(PrincipalComponents, ThereAreNoneInOneRowOrNothing) {
  EXPECT_EQ(principal_components(random_matrix(1, 5, 5)).count(), 0);
  EXPECT_EQ(principal_components(Eigen::MatrixXd(0, 5)).count(), 0);
  EXPECT_EQ(principal_components(Eigen::MatrixXd(5, 0)).count(), 0);
  EXPECT_EQ(principal_components(Eigen::MatrixXd::Constant(8, 3, 2)).count(), 0);
}

}  // namespace
}  // namespace mocapress
