// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// Lloyd's algorithm from rows evenly spaced in order: each row's cluster, in [0, clusters). The
/// same for the same rows.
std::vector<int> k_means(const Eigen::MatrixXd& rows, int clusters);

}  // namespace mocapress
