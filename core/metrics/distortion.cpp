// SPDX-License-Identifier: MIT
#include "core/metrics/distortion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/motion/track_blocks.h"

namespace mocapress {
namespace {

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

DistortionMeter::DistortionMeter(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks)
    : skeleton_(skeleton),
      original_tracks_(original_tracks),
      squared_(original_tracks.rows(), original_tracks.cols() / 3) {}

void DistortionMeter::add(int first_frame, const Eigen::MatrixXd& decoded_tracks) {
  const Eigen::Index count = decoded_tracks.rows();
  assert(first_frame + count <= squared_.rows() &&
         decoded_tracks.cols() == original_tracks_.cols());
  for (Eigen::Index p = 0; p < squared_.cols(); ++p)
    squared_.col(p).segment(first_frame, count) =
        (original_tracks_.middleCols<3>(3 * p).middleRows(first_frame, count) -
         decoded_tracks.middleCols<3>(3 * p))
            .rowwise()
            .squaredNorm();
}

double DistortionMeter::eps(Weighting weighting) const {
  return eps_from(squared_, landmark_weights(skeleton_, weighting));
}

Distortion DistortionMeter::distortion() const {
  Distortion distortion;
  distortion.eps_bone_ends = eps(Weighting::BoneEnds);
  distortion.eps_joint_origins = eps(Weighting::JointOrigins);
  distortion.distances = squared_.cwiseSqrt().cast<float>();
  if (squared_.size() == 0) return distortion;

  Eigen::Index frame = 0;
  Eigen::Index landmark = 0;
  const double worst = squared_.maxCoeff(&frame, &landmark);
  distortion.max = {static_cast<int>(frame), static_cast<int>(landmark), std::sqrt(worst)};
  std::vector<float> all(distortion.distances.data(),
                         distortion.distances.data() + distortion.distances.size());
  distortion.p95 = percentile(all, 0.95);
  distortion.p99 = percentile(all, 0.99);
  return distortion;
}

Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded) {
  return measure(skeleton, landmark_tracks(skeleton, original), decoded);
}

namespace {

DistortionMeter meter_of(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                         const Clip& decoded) {
  DistortionMeter meter(skeleton, original_tracks);
  visit_tracks(skeleton, decoded,
               [&](int first, const Eigen::MatrixXd& tracks) { meter.add(first, tracks); });
  return meter;
}

}  // namespace

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded) {
  return meter_of(skeleton, original_tracks, decoded).distortion();
}

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Eigen::MatrixXd& decoded_tracks) {
  assert(original_tracks.rows() == decoded_tracks.rows());
  DistortionMeter meter(skeleton, original_tracks);
  meter.add(0, decoded_tracks);
  return meter.distortion();
}

double exact_eps(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                 const Clip& decoded, Weighting weighting) {
  return meter_of(skeleton, original_tracks, decoded).eps(weighting);
}

}  // namespace mocapress
