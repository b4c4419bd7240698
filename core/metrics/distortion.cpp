// SPDX-License-Identifier: MIT
#include "core/metrics/distortion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace mocapress {
namespace {

/// frames x landmarks, squared cm.
Eigen::MatrixXd squared_distances(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  assert(a.rows() == b.rows() && a.cols() == b.cols());
  Eigen::MatrixXd squared(a.rows(), a.cols() / 3);
  for (Eigen::Index p = 0; p < squared.cols(); ++p)
    squared.col(p) = (a.middleCols<3>(3 * p) - b.middleCols<3>(3 * p)).rowwise().squaredNorm();
  return squared;
}

/// The mean over time of the weighted sum over landmarks, and its root.
double eps_from(const Eigen::MatrixXd& squared, const Eigen::VectorXd& weights) {
  if (squared.rows() == 0) return 0;
  return std::sqrt(squared.colwise().mean().dot(weights));
}

/// The smallest value that at least `share` of all values do not exceed. Reorders `values`.
double percentile(std::vector<float>& values, double share) {
  if (values.empty()) return 0;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto nth = values.begin() + std::max<std::ptrdiff_t>(rank - 1, 0);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded) {
  return measure(skeleton, landmark_tracks(skeleton, original), decoded);
}

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded) {
  return measure(skeleton, original_tracks, landmark_tracks(skeleton, decoded));
}

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Eigen::MatrixXd& decoded_tracks) {
  const Eigen::MatrixXd squared = squared_distances(original_tracks, decoded_tracks);
  Distortion distortion;
  distortion.eps_bone_ends = eps_from(squared, landmark_weights(skeleton, Weighting::BoneEnds));
  distortion.eps_joint_origins =
      eps_from(squared, landmark_weights(skeleton, Weighting::JointOrigins));
  distortion.distances = squared.cwiseSqrt().cast<float>();
  if (squared.size() == 0) return distortion;

  Eigen::Index frame = 0;
  Eigen::Index landmark = 0;
  const double worst = squared.maxCoeff(&frame, &landmark);
  distortion.max = {static_cast<int>(frame), static_cast<int>(landmark), std::sqrt(worst)};
  std::vector<float> all(distortion.distances.data(),
                         distortion.distances.data() + distortion.distances.size());
  distortion.p95 = percentile(all, 0.95);
  distortion.p99 = percentile(all, 0.99);
  return distortion;
}

double exact_eps(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                 const Clip& decoded, Weighting weighting) {
  return eps_from(squared_distances(original_tracks, landmark_tracks(skeleton, decoded)),
                  landmark_weights(skeleton, weighting));
}

}  // namespace mocapress
