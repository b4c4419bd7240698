// SPDX-License-Identifier: MIT
#include "core/metrics/distortion.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/motion/body_part.h"

namespace mocapress {

namespace {

constexpr int kFraction = 23;  // bits of a float

}  // namespace

void DistanceCounts::add(float distance) {
  // Ordered as the floats are, where these are not negative.
  const auto bits = std::bit_cast<std::uint32_t>(distance) & 0x7FFFFFFFU;
  std::vector<std::uint64_t>& octave = octaves_[bits >> kFraction];
  if (octave.empty()) octave.resize(1U << kBits);
  ++octave[(bits >> (kFraction - kBits)) & ((1U << kBits) - 1)];
  ++all_;
}

double DistanceCounts::percentile(double share) const {
  const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(all_)));
  std::uint64_t below = 0;
  for (std::uint32_t exponent = 0; exponent < octaves_.size(); ++exponent)
    for (std::uint32_t part = 0; part < octaves_[exponent].size(); ++part) {
      below += octaves_[exponent][part];
      if (below >= std::max<std::uint64_t>(rank, 1))
        return std::bit_cast<float>(exponent << kFraction | part << (kFraction - kBits));
    }
  return 0;
}

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

std::vector<float> all_of(const Eigen::MatrixXf& values) {
  return {values.data(), values.data() + values.size()};
}

}  // namespace

double Distortion::eps(Weighting weighting) const {
  switch (weighting) {
    case Weighting::BoneEnds:
      return eps_bone_ends;
    case Weighting::JointOrigins:
      return eps_joint_origins;
    case Weighting::Surface:
      return surface.rms;
    case Weighting::Shell:
      return shell.rms;
  }
  return 0;
}

const WorstPoint& Distortion::worst(Weighting weighting) const {
  if (is_on_bones(weighting)) return max;
  return weighting == Weighting::Surface ? surface.max : shell.max;
}

double Distortion::degrees(const std::vector<int>& joints) const {
  if (joints.empty()) return 0;
  return std::sqrt(joint_degrees(joints).squaredNorm() / static_cast<double>(joints.size()));
}

PointErrors::PointErrors(const Skeleton& skeleton, Weighting weighting)
    : skeleton_(skeleton), weighting_(weighting), measured_(measured_points(skeleton, weighting)) {}

Eigen::MatrixXd PointErrors::squared(const TrackRows& original, const TrackRows& decoded) const {
  const std::vector<Landmark>& points = measured_.points;
  Eigen::MatrixXd squared(original.rows(), std::ssize(points));
  if (is_on_bones(weighting_)) {  // which tracks begin with
    for (Eigen::Index p = 0; p < squared.cols(); ++p)
      squared.col(p) =
          (original.middleCols<3>(3 * p) - decoded.middleCols<3>(3 * p)).rowwise().squaredNorm();
    return squared;
  }
  const JointErrors errors(skeleton_, original, decoded);
  Eigen::Matrix<double, Eigen::Dynamic, 12> of_joint;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (p == 0 || points[p].joint != points[p - 1].joint) of_joint = errors.of(points[p].joint);
    squared.col(static_cast<Eigen::Index>(p)) = JointErrors::squared(of_joint, points[p].in_joint);
  }
  return squared;
}

DistortionMeter::DistortionMeter(const Skeleton& skeleton, int frames, Detail detail,
                                 Weighting weighting)
    : skeleton_(skeleton),
      detail_(detail),
      squared_turns_(Eigen::VectorXd::Zero(skeleton.joint_count())),
      ends_(std::ssize(landmarks(skeleton))) {
  const auto look_at = [&](Weighting points) {
    Set set{.errors = PointErrors(skeleton, points)};
    set.squares = Eigen::VectorXd::Zero(set.errors.measured().weights.size());
    sets_.push_back(std::move(set));
  };
  if (detail == Detail::Means) {
    look_at(weighting);
    return;
  }
  for (const Weighting all : {Weighting::BoneEnds, Weighting::Surface, Weighting::Shell})
    look_at(all);
  if (detail != Detail::Distances) return;
  distances_.resize(frames, sets_.front().squares.size());
  turns_.resize(frames, distances_.cols());
}

void DistortionMeter::add(Set& set, int first_frame, const Eigen::MatrixXd& squared) const {
  if (squared.size() == 0) return;
  for (Eigen::Index p = 0; p < squared.cols(); ++p) set.squares(p) += squared.col(p).sum();
  Eigen::Index frame = 0;
  Eigen::Index point = 0;
  const double worst = squared.maxCoeff(&frame, &point);
  if (worst > set.worst_square) {
    set.worst_square = worst;
    const int joint = set.errors.measured().points[static_cast<std::size_t>(point)].joint;
    set.worst = {first_frame + static_cast<int>(frame),
                 is_on_bones(set.errors.weighting()) ? static_cast<int>(point) : joint,
                 std::sqrt(worst)};
  }
  const bool has_distances = detail_ == Detail::Distances && &set == &sets_.front();
  if (detail_ == Detail::Means || has_distances) return;
  for (const double square : squared.reshaped())
    set.counts.add(static_cast<float>(std::sqrt(square)));
}

void DistortionMeter::add_turns(int first_frame, const TrackRows& original,
                                const TrackRows& decoded) {
  const JointErrors errors(skeleton_, original, decoded);
  for (int j = 0; j < skeleton_.joint_count(); ++j) {
    const Eigen::VectorXd degrees = JointErrors::degrees(errors.of(j));
    squared_turns_(j) += degrees.squaredNorm();
    if (detail_ == Detail::Distances)
      turns_.col(j).segment(first_frame, degrees.size()) = degrees.cast<float>();
  }
  // Ends of bones come after all joints and turn with theirs.
  const std::vector<Landmark>& points = sets_.front().errors.measured().points;
  for (Eigen::Index end = skeleton_.joint_count(); end < turns_.cols(); ++end)
    turns_.col(end).segment(first_frame, original.rows()) =
        turns_.col(points[static_cast<std::size_t>(end)].joint)
            .segment(first_frame, original.rows());
}

void DistortionMeter::add(int first_frame, const TrackRows& original, const TrackRows& decoded) {
  frames_ += original.rows();
  for (Set& set : sets_) {
    const Eigen::MatrixXd squared = set.errors.squared(original, decoded);
    add(set, first_frame, squared);
    if (detail_ != Detail::Means && set.errors.weighting() == Weighting::Surface)
      ends_.add(original, decoded, squared * set.errors.measured().weights);
    if (detail_ == Detail::Distances && &set == &sets_.front())
      distances_.middleRows(first_frame, squared.rows()) = squared.cwiseSqrt().cast<float>();
  }
  if (detail_ != Detail::Means) add_turns(first_frame, original, decoded);
}

double DistortionMeter::eps(std::size_t set, const Eigen::VectorXd& weights) const {
  if (frames_ == 0) return 0;
  double mean_square = 0;
  for (Eigen::Index p = 0; p < weights.size(); ++p)
    mean_square += sets_[set].squares(p) / static_cast<double>(frames_) * weights(p);
  return std::sqrt(mean_square);
}

Spread DistortionMeter::spread(std::size_t set) const {
  const DistanceCounts& counts = sets_[set].counts;
  return {eps(set), counts.percentile(0.95), counts.percentile(0.99), sets_[set].worst};
}

Distortion DistortionMeter::distortion() const {
  assert(detail_ != Detail::Means);
  Distortion distortion{
      .eps_bone_ends = eps(),
      .eps_joint_origins = eps(0, landmark_weights(skeleton_, Weighting::JointOrigins)),
      .max = worst(),
      .distances = distances_,
      .surface = spread(1),
      .shell = spread(2),
      .joint_degrees = squared_turns_,
      .turns = turns_,
      .ends = ends_.errors()};
  if (frames_ > 0)
    distortion.joint_degrees = (squared_turns_ / static_cast<double>(frames_)).cwiseSqrt();
  if (detail_ == Detail::Distances) {
    std::vector<float> all = all_of(distances_);
    distortion.p95 = percentile(all, 0.95);
    distortion.p99 = percentile(all, 0.99);
    all = all_of(turns_);
    distortion.p99_degrees = percentile(all, 0.99);
  } else {
    distortion.p95 = sets_.front().counts.percentile(0.95);
    distortion.p99 = sets_.front().counts.percentile(0.99);
  }
  return distortion;
}

Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded) {
  return measure(skeleton, body_tracks(skeleton, original), decoded);
}

namespace {

DistortionMeter meter_of(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                         const Clip& decoded, Detail detail, Weighting weighting) {
  DistortionMeter meter(skeleton, decoded.frames(), detail, weighting);
  visit_tracks(skeleton, decoded, [&](int first, const Eigen::MatrixXd& tracks) {
    meter.add(first, original_tracks.middleRows(first, tracks.rows()), tracks);
  });
  return meter;
}

}  // namespace

Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded) {
  return meter_of(skeleton, original_tracks, decoded, Detail::Distances, Weighting::BoneEnds)
      .distortion();
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
  return meter_of(skeleton, original_tracks, decoded, Detail::Means, weighting).eps();
}

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion) {
  const auto degrees = [&](const std::vector<int>& joints) -> std::optional<double> {
    if (joints.empty()) return std::nullopt;
    return distortion.degrees(joints);
  };
  std::vector<int> all(static_cast<std::size_t>(skeleton.joint_count()));
  std::iota(all.begin(), all.end(), 0);
  return {.surface = distortion.surface,
          .shell = distortion.shell,
          .head_degrees = degrees(head_joints(skeleton)),
          .hand_degrees = degrees(joints_of(skeleton, BodyPart::Hands)),
          .angle_rms_degrees = distortion.degrees(all),
          .ends = distortion.ends};
}

}  // namespace mocapress
