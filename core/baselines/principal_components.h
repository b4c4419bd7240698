// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Principal components of rows: row = mean + (its row of projections) * basis^T.
struct PrincipalComponents {
  Eigen::VectorXd mean;
  Eigen::MatrixXd basis;        // orthonormal, a column for each component, largest variance first
  Eigen::MatrixXd projections;  // rows x components
  Eigen::VectorXd variances;    // each component's mean squared projection

  int count() const { return static_cast<int>(basis.cols()); }

  /// The least number of components that leaves a mean squared error of at most `squared_error`.
  int enough_for(double squared_error) const;
};

/// Decomposes rows into principal components. Leaves out components without variance: there are at
/// most rows - 1, and at most as many as columns.
PrincipalComponents principal_components(Eigen::MatrixXd rows);

}  // namespace mocapress
