// SPDX-License-Identifier: MIT
#include "core/baselines/principal_components.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace mocapress {

int PrincipalComponents::enough_for(double squared_error) const {
  int components = count();
  for (double left = 0; components > 0; --components) {
    left += variances(components - 1);
    if (left > squared_error) break;
  }
  return components;
}

PrincipalComponents principal_components(Eigen::MatrixXd rows) {
  constexpr double kNothing = 1e-14;  // smaller shares of the largest variance count as 0
  PrincipalComponents result;
  result.mean = Eigen::VectorXd::Zero(rows.cols());
  if (rows.size() > 0) {
    result.mean = rows.colwise().mean();
    rows.rowwise() -= result.mean.transpose();
  }
  // rows * rows^T and rows^T * rows have the same eigenvalues: takes the smaller one.
  const bool few_rows = rows.rows() < rows.cols();
  const Eigen::MatrixXd tall = few_rows ? Eigen::MatrixXd(rows.transpose()) : rows;
  const Eigen::Index size = tall.cols();
  Eigen::MatrixXd vectors(size, 0);
  if (size > 0) {
    const Eigen::MatrixXd product = tall.transpose() * tall;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(product);
    const Eigen::VectorXd values = eigen.eigenvalues().reverse();
    const Eigen::Index most = std::min(size, rows.rows() - 1);
    Eigen::Index count = 0;
    while (count < most && values(count) > kNothing * values(0)) ++count;
    vectors = eigen.eigenvectors().rowwise().reverse().leftCols(count);
  }
  result.basis = vectors;
  if (few_rows) result.basis = tall * vectors;
  if (few_rows) result.basis.colwise().normalize();
  result.projections = rows * result.basis;
  result.variances = Eigen::VectorXd::Zero(result.basis.cols());
  if (rows.rows() > 0)
    result.variances =
        result.projections.colwise().squaredNorm() / static_cast<double>(rows.rows());
  return result;
}

}  // namespace mocapress
