// SPDX-License-Identifier: MIT
#include "core/metrics/distortion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/motion/body_part.h"

namespace mocapress {

void DistanceCounts::open(std::uint32_t exponent) {
  places_[exponent] = counts_.size();
  counts_.resize(counts_.size() + (std::size_t{1} << kBits));
}

double DistanceCounts::percentile(double share) const {
  const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(all_)));
  std::uint64_t below = 0;
  for (std::uint32_t exponent = 0; exponent < places_.size(); ++exponent)
    for (std::uint32_t part = 0; places_[exponent] != kNone && part < 1U << kBits; ++part) {
      below += counts_[places_[exponent] + part];
      if (below >= std::max<std::uint64_t>(rank, 1))
        return std::bit_cast<float>(exponent << kFraction | part << (kFraction - kBits));
    }
  return 0;
}

namespace {

/// The smallest value that at least `share` of all values do not exceed. Reorders `values`. `after`
/// in/out: the place where the previous call, for a smaller share, partitioned `values`.
double percentile(std::vector<float>& values, double share, std::ptrdiff_t* after = nullptr) {
  if (values.empty()) return 0;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const std::ptrdiff_t place = std::max<std::ptrdiff_t>(rank - 1, 0);
  std::nth_element(values.begin() + (after ? *after : 0), values.begin() + place, values.end());
  if (after) *after = place;
  return values[place];
}

std::vector<float> all_of(const Eigen::MatrixXf& values) {
  return {values.data(), values.data() + values.size()};
}

}  // namespace

Spread Distortion::spread(Weighting weighting) const {
  if (is_on_bones(weighting))
    return {weighting == Weighting::BoneEnds ? eps_bone_ends : eps_joint_origins, p95, p99, max};
  if (weighting == Weighting::Skin) return skin.value_or(Spread());
  return weighting == Weighting::Shell ? shell : surface;
}

double Distortion::degrees(const std::vector<int>& joints) const {
  if (joints.empty()) return 0;
  return std::sqrt(joint_degrees(joints).squaredNorm() / static_cast<double>(joints.size()));
}

namespace {

/// The points of a weighting. For Weighting::Skin, the points of the skin itself, not those of
/// carried_points(), which approximate their error.
MeasuredPoints points_of(const Skeleton& skeleton, Weighting weighting) {
  MeasuredPoints measured = measured_points(skeleton, weighting);
  if (weighting != Weighting::Skin) return measured;
  const SkinPoints& skin = *skeleton.skin();
  measured.points.clear();
  for (const SkinPoint& point : skin)
    measured.points.push_back(
        {point.front().joint, point.front().in_joint, skeleton.joint(point.front().joint).name});
  measured.weights =
      Eigen::VectorXd::Constant(std::ssize(skin), 1 / static_cast<double>(skin.size()));
  return measured;
}

/// Squared errors (cm^2) of the skin's points: frames x points.
Eigen::MatrixXd squared_on(const SkinPoints& skin, JointErrors& errors, Eigen::Index frames) {
  Eigen::MatrixXd squared(frames, std::ssize(skin));
  Eigen::MatrixX3d moved(frames, 3);
  for (std::size_t p = 0; p < skin.size(); ++p) {
    moved.setZero();
    for (const auto& [joint, in_joint, weight] : skin[p]) {
      const auto& of_joint = errors.of(joint);
      moved += weight * of_joint.leftCols<3>();
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        moved += (weight * in_joint(axis)) * of_joint.middleCols<3>(3 + 3 * axis);
    }
    squared.col(p) = moved.rowwise().squaredNorm();
  }
  return squared;
}

}  // namespace

PointErrors::PointErrors(const Skeleton& skeleton, Weighting weighting)
    : skeleton_(skeleton), weighting_(weighting), measured_(points_of(skeleton, weighting)) {}

Eigen::MatrixXd PointErrors::squared(const TrackRows& original, const TrackRows& decoded) const {
  JointErrors errors(skeleton_, original, decoded);
  return squared(original, decoded, errors);
}

Eigen::MatrixXd PointErrors::squared(const TrackRows& original, const TrackRows& decoded,
                                     JointErrors& errors) const {
  const std::vector<Landmark>& points = measured_.points;
  Eigen::MatrixXd squared(original.rows(), std::ssize(points));
  if (is_on_bones(weighting_)) {  // the points are the first columns of the tracks
    const auto along = [&](Eigen::Index i) {
      return (original.col(i) - decoded.col(i)).cwiseAbs2();
    };
    for (Eigen::Index p = 0; p < squared.cols(); ++p)
      squared.col(p) = along(3 * p) + along(3 * p + 1) + along(3 * p + 2);
    return squared;
  }
  if (weighting_ == Weighting::Skin) return squared_on(*skeleton_.skin(), errors, original.rows());
  for (std::size_t p = 0; p < points.size(); ++p)
    JointErrors::find_squares(errors.of(points[p].joint), points[p].in_joint, squared.col(p));
  return squared;
}

namespace {

constexpr std::size_t kSkinSet = 3;  // index after landmarks, surface and shell

}  // namespace

DistortionMeter::DistortionMeter(const Skeleton& skeleton, int frames, Detail detail,
                                 Weighting weighting, Eigen::VectorXd frame_factors)
    : skeleton_(skeleton),
      detail_(detail),
      frame_factors_(std::move(frame_factors)),
      squared_turns_(Eigen::VectorXd::Zero(skeleton.joint_count())),
      greatest_turns_(squared_turns_),
      ends_(std::ssize(landmarks(skeleton))) {
  const auto look_at = [&](Weighting points) {
    Set set{.errors = PointErrors(skeleton, points)};
    set.squares = Eigen::VectorXd::Zero(set.errors.measured().weights.size());
    set.greatest = set.squares;
    sets_.push_back(std::move(set));
  };
  if (detail == Detail::Means) {
    look_at(weighting);
    return;
  }
  for (const Weighting all : {Weighting::BoneEnds, Weighting::Surface, Weighting::Shell})
    look_at(all);
  if (skeleton.skin()) look_at(Weighting::Skin);
  if (detail != Detail::Distances) return;
  distances_.resize(frames, sets_.front().squares.size());
  turns_.resize(frames, distances_.cols());
}

void DistortionMeter::add(Set& set, int first_frame, const Eigen::MatrixXd& squared) const {
  if (squared.size() == 0) return;
  double worst = 0;
  for (Eigen::Index p = 0; p < squared.cols(); ++p) {
    set.squares(p) += squared.col(p).sum();
    const double greatest = squared.col(p).maxCoeff();
    set.greatest(p) = std::max(set.greatest(p), greatest);
    worst = std::max(worst, greatest);
  }
  if (worst > set.worst_square) {
    Eigen::Index frame = 0;
    Eigen::Index point = 0;
    squared.maxCoeff(&frame, &point);
    set.worst_square = worst;
    const int joint = set.errors.measured().points[point].joint;
    set.worst = {first_frame + static_cast<int>(frame),
                 is_on_bones(set.errors.weighting()) ? static_cast<int>(point) : joint,
                 std::sqrt(worst)};
  }
  const bool has_distances = detail_ == Detail::Distances && &set == &sets_.front();
  if (detail_ == Detail::Means || has_distances) return;
  const Eigen::MatrixXf distances = squared.cwiseSqrt().cast<float>();
  const float* const end = distances.data() + distances.size();
  for (const float* distance = distances.data(); distance != end; ++distance)
    set.counts.add(*distance);
}

const WorstPoint& DistortionMeter::worst(Weighting weighting) const {
  const auto set =
      std::ranges::find(sets_, weighting, [](const Set& each) { return each.errors.weighting(); });
  return set == sets_.end() ? worst() : set->worst;
}

void DistortionMeter::add_turns(int first_frame, Eigen::Index frames, JointErrors& errors) {
  for (int j = 0; j < skeleton_.joint_count(); ++j) {
    const Eigen::VectorXd degrees = JointErrors::degrees(errors.of(j));
    squared_turns_(j) += degrees.squaredNorm();
    if (degrees.size() > 0) greatest_turns_(j) = std::max(greatest_turns_(j), degrees.maxCoeff());
    if (detail_ == Detail::Distances)
      turns_.col(j).segment(first_frame, frames) = degrees.cast<float>();
  }
  // A bone end turns with its joint. In the list of points, bone ends follow all joints.
  const std::vector<Landmark>& points = sets_.front().errors.measured().points;
  for (Eigen::Index end = skeleton_.joint_count(); end < turns_.cols(); ++end)
    turns_.col(end).segment(first_frame, frames) =
        turns_.col(points[end].joint).segment(first_frame, frames);
}

void DistortionMeter::add(int first_frame, const TrackRows& original, const TrackRows& decoded) {
  constexpr Eigen::Index kFrames = 64;  // at a time, so that the joints' errors stay in the cache
  for (Eigen::Index first = 0; first < original.rows(); first += kFrames) {
    const Eigen::Index frames = std::min(kFrames, original.rows() - first);
    add_some(first_frame + static_cast<int>(first), original.middleRows(first, frames),
             decoded.middleRows(first, frames));
  }
}

void DistortionMeter::add_some(int first_frame, const TrackRows& original,
                               const TrackRows& decoded) {
  frames_ += original.rows();
  JointErrors errors(skeleton_, original, decoded);
  for (Set& set : sets_) {
    Eigen::MatrixXd squared = set.errors.squared(original, decoded, errors);
    if (frame_factors_.size() > 0)
      squared.array().colwise() *=
          frame_factors_.segment(first_frame, squared.rows()).array().square();
    add(set, first_frame, squared);
    if (detail_ != Detail::Means && set.errors.weighting() == Weighting::Surface)
      ends_.add(original, decoded, squared * set.errors.measured().weights);
    if (detail_ == Detail::Distances && &set == &sets_.front())
      distances_.middleRows(first_frame, squared.rows()) = squared.cwiseSqrt().cast<float>();
  }
  if (detail_ != Detail::Means) add_turns(first_frame, original.rows(), errors);
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

Eigen::MatrixX2d DistortionMeter::skin_of_joints() const {
  const Set& skin = sets_[kSkinSet];
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(skeleton_.joint_count());
  Eigen::MatrixX2d found = Eigen::MatrixX2d::Zero(counts.size(), 2);
  for (Eigen::Index p = 0; p < skin.squares.size(); ++p) {
    const int joint = skin.errors.measured().points[p].joint;
    ++counts(joint);
    found(joint, 0) += skin.squares(p);
    found(joint, 1) = std::max(found(joint, 1), skin.greatest(p));
  }
  const auto frames = static_cast<double>(std::max<Eigen::Index>(frames_, 1));
  for (Eigen::Index j = 0; j < counts.size(); ++j)
    if (counts(j) > 0)
      found.row(j) << std::sqrt(found(j, 0) / (frames * counts(j))), std::sqrt(found(j, 1));
    else
      found.row(j).setConstant(-1);
  return found;
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
      .joint_max_degrees = greatest_turns_,
      .joint_max_cm = sets_.front().greatest.head(skeleton_.joint_count()).cwiseSqrt(),
      .turns = turns_,
      .ends = ends_.errors()};
  if (skeleton_.skin()) {
    distortion.skin = spread(kSkinSet);
    distortion.skin_of_joints = skin_of_joints();
  }
  if (frames_ > 0)
    distortion.joint_degrees = (squared_turns_ / static_cast<double>(frames_)).cwiseSqrt();
  if (detail_ == Detail::Distances) {
    std::vector<float> all = all_of(distances_);
    std::ptrdiff_t after = 0;
    distortion.p95 = percentile(all, 0.95, &after);
    distortion.p99 = percentile(all, 0.99, &after);
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

std::optional<PartTurn> worst_turn(const Distortion& distortion, const std::vector<int>& joints) {
  if (joints.empty()) return std::nullopt;
  PartTurn worst;
  for (const int j : joints) {
    worst.rms_degrees = std::max(worst.rms_degrees, distortion.joint_degrees(j));
    worst.max_degrees = std::max(worst.max_degrees, distortion.joint_max_degrees(j));
  }
  return worst;
}

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion) {
  const auto turn_of = [&](BodyPart part) {
    return worst_turn(distortion, namesakes_of(skeleton, part));
  };
  std::vector<int> all(skeleton.joint_count());
  std::iota(all.begin(), all.end(), 0);
  BodyFigures figures{.surface = distortion.surface,
                      .shell = distortion.shell,
                      .skin = distortion.skin,
                      .head = turn_of(BodyPart::Head),
                      .hand = turn_of(BodyPart::Hands),
                      .finger = turn_of(BodyPart::Fingers),
                      .foot = turn_of(BodyPart::Feet),
                      .angle_rms_degrees = distortion.degrees(all),
                      .ends = distortion.ends};
  if (skeleton.joint_count() > 0) {
    figures.root_max_cm = distortion.joint_max_cm(0);
    figures.root_max_degrees = distortion.joint_max_degrees(0);
  }
  return figures;
}

}  // namespace mocapress
