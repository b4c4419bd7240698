// SPDX-License-Identifier: MIT
#include "core/metrics/distortion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace mocapress {
namespace {

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

Eigen::MatrixXd squared_distances(const TrackRows& original, const TrackRows& decoded) {
  assert(original.rows() == decoded.rows() && original.cols() == decoded.cols());
  Eigen::MatrixXd squared(original.rows(), original.cols() / 3);
  for (Eigen::Index p = 0; p < squared.cols(); ++p)
    squared.col(p) =
        (original.middleCols<3>(3 * p) - decoded.middleCols<3>(3 * p)).rowwise().squaredNorm();
  return squared;
}

DistortionMeter::DistortionMeter(const Skeleton& skeleton, int frames, Detail detail)
    : detail_(detail),
      bone_end_weights_(landmark_weights(skeleton, Weighting::BoneEnds)),
      joint_origin_weights_(landmark_weights(skeleton, Weighting::JointOrigins)),
      squares_(Eigen::VectorXd::Zero(bone_end_weights_.size())) {
  if (detail == Detail::Distances) distances_.resize(frames, squares_.size());
}

void DistortionMeter::add(int first_frame, const TrackRows& original, const TrackRows& decoded) {
  const Eigen::MatrixXd squared = squared_distances(original, decoded);
  if (squared.size() == 0) return;
  for (Eigen::Index p = 0; p < squared.cols(); ++p) squares_(p) += squared.col(p).sum();
  frames_ += squared.rows();
  Eigen::Index frame = 0;
  Eigen::Index landmark = 0;
  const double worst = squared.maxCoeff(&frame, &landmark);
  if (worst > worst_square_) {
    worst_square_ = worst;
    worst_ = {first_frame + static_cast<int>(frame), static_cast<int>(landmark), std::sqrt(worst)};
  }
  if (detail_ == Detail::Distances)
    distances_.middleRows(first_frame, squared.rows()) = squared.cwiseSqrt().cast<float>();
  if (detail_ == Detail::Figures)
    for (const double square : squared.reshaped())
      counts_.add(static_cast<float>(std::sqrt(square)));
}

double DistortionMeter::eps(Weighting weighting) const {
  if (frames_ == 0) return 0;
  const Eigen::VectorXd& weights =
      weighting == Weighting::BoneEnds ? bone_end_weights_ : joint_origin_weights_;
  double mean_square = 0;
  for (Eigen::Index p = 0; p < weights.size(); ++p)
    mean_square += squares_(p) / static_cast<double>(frames_) * weights(p);
  return std::sqrt(mean_square);
}

Distortion DistortionMeter::distortion() const {
  Distortion distortion{.eps_bone_ends = eps(Weighting::BoneEnds),
                        .eps_joint_origins = eps(Weighting::JointOrigins),
                        .max = worst_,
                        .distances = distances_};
  if (detail_ == Detail::Distances) {
    std::vector<float> all(distances_.data(), distances_.data() + distances_.size());
    distortion.p95 = percentile(all, 0.95);
    distortion.p99 = percentile(all, 0.99);
  } else {
    distortion.p95 = counts_.percentile(0.95);
    distortion.p99 = counts_.percentile(0.99);
  }
  return distortion;
}

Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded) {
  return measure(skeleton, landmark_tracks(skeleton, original), decoded);
}

namespace {

DistortionMeter meter_of(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                         const Clip& decoded, Detail detail) {
  DistortionMeter meter(skeleton, decoded.frames(), detail);
  visit_tracks(skeleton, decoded, [&](int first, const Eigen::MatrixXd& tracks) {
    meter.add(first, original_tracks.middleRows(first, tracks.rows()), tracks);
  });
  return meter;
}

}  // namespace

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded) {
  return meter_of(skeleton, original_tracks, decoded, Detail::Distances).distortion();
}

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Eigen::MatrixXd& decoded_tracks) {
  assert(original_tracks.rows() == decoded_tracks.rows());
  DistortionMeter meter(skeleton, static_cast<int>(decoded_tracks.rows()), Detail::Distances);
  meter.add(0, original_tracks, decoded_tracks);
  return meter.distortion();
}

double exact_eps(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                 const Clip& decoded, Weighting weighting) {
  return meter_of(skeleton, original_tracks, decoded, Detail::Means).eps(weighting);
}

}  // namespace mocapress
