// SPDX-License-Identifier: MIT
#include "core/baselines/k_means.h"

namespace mocapress {
namespace {

std::vector<int> nearest(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& centres) {
  // The squared distance |row - centre|^2, without |row|^2, which is the same for all centres.
  const Eigen::MatrixXd distances =
      (-2 * rows * centres.transpose()).rowwise() + centres.rowwise().squaredNorm().transpose();
  std::vector<int> clusters;
  for (const auto& of_row : distances.rowwise()) {
    Eigen::Index cluster = 0;
    of_row.minCoeff(&cluster);
    clusters.push_back(static_cast<int>(cluster));
  }
  return clusters;
}

}  // namespace

std::vector<int> k_means(const Eigen::MatrixXd& rows, int clusters) {
  constexpr int kMostRounds = 20;
  Eigen::MatrixXd centres(clusters, rows.cols());
  for (Eigen::Index c = 0; c < clusters; ++c)
    centres.row(c) = rows.row((2 * c + 1) * rows.rows() / (2 * clusters));
  std::vector<int> of_rows = nearest(rows, centres);
  for (int round = 0; round < kMostRounds; ++round) {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(clusters, rows.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(clusters);
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
      const int cluster = of_rows[r];
      sums.row(cluster) += rows.row(r);
      counts(cluster) += 1;
    }
    for (Eigen::Index c = 0; c < clusters; ++c)
      if (counts(c) > 0) centres.row(c) = sums.row(c) / counts(c);
    std::vector<int> next = nearest(rows, centres);
    if (next == of_rows) break;
    of_rows = std::move(next);
  }
  return of_rows;
}

}  // namespace mocapress
