// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Rows taken apart: row = mean + projections.row * basis^T.
struct PrincipalComponents {
  Eigen::VectorXd mean;
  Eigen::MatrixXd basis;        // columns of the rows x components, orthonormal, the largest first
  Eigen::MatrixXd projections;  // rows x components
  Eigen::VectorXd variances;    // mean squared projection of each component

  int count() const { return static_cast<int>(basis.cols()); }

  /// The fewest components that leave a mean squared error of no more than this.
  int enough_for(double squared_error) const;
};

/// Components that explain nothing are left out: at most rows - 1 and columns.
PrincipalComponents principal_components(Eigen::MatrixXd rows);

}  // namespace mocapress
