// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// Lloyd's algorithm for k-means. Starts with rows at even distances as centres. Returns each row's
/// cluster, in [0, clusters). Equal rows give equal clusters.
std::vector<int> k_means(const Eigen::MatrixXd& rows, int clusters);

}  // namespace mocapress
