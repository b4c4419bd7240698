// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6 (composite rigid
// bodies).
#include "core/select/error_model.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/parallel.h"
#include "core/motion/pose_block.h"
#include "core/select/composite_body.h"
#include "core/select/sweep_kernels.h"

namespace mocapress {
namespace {

constexpr int kVector = 8;                               // numbers
constexpr Eigen::Index kSampleEvery = 2;                 // frames
constexpr Eigen::Index kBlock = CompositeBody::kFrames;  // frames at a time

/// Some numbers for each frame of a block.
template <int count, typename Number = double>
using Block = Eigen::Array<Number, Eigen::Dynamic, count, Eigen::ColMajor, kBlock, count>;

/// Columns count * index ... of a matrix with as many a thing.
template <int count, typename Matrix>
auto columns(const Matrix& matrix, int index, Eigen::Index first, Eigen::Index frames) {
  return matrix.block(first, static_cast<Eigen::Index>(index) * count, frames, count).array();
}

/// Three columns of a matrix with three for each thing, from a frame on.
ThreeColumns three_of(const Eigen::MatrixXd& matrix, int index, Eigen::Index first) {
  const double* const from = matrix.data() + Eigen::Index{3} * index * matrix.rows() + first;
  return {from, from + matrix.rows(), from + 2 * matrix.rows()};
}

std::array<float*, 6> six_from(Eigen::MatrixXf& matrix, Eigen::Index index, Eigen::Index first) {
  std::array<float*, 6> columns;
  for (Eigen::Index i = 0; i < 6; ++i)
    columns[static_cast<std::size_t>(i)] = matrix.col(6 * index + i).data() + first;
  return columns;
}

}  // namespace

/// Of the skeleton's own channels: unit axes.
ErrorModel::Posed ErrorModel::pose_channels(const Skeleton& skeleton, const Clip& original,
                                            const std::vector<Landmark>& points) {
  const std::vector<Landmark> origins = joint_origins(skeleton);
  Posed posed;
  posed.origins.resize(original.frames(), 3 * std::ssize(origins));
  posed.points.resize(original.frames(), 3 * std::ssize(points));
  SignalMoves& moves = posed.moves;
  for (int c = 0; c < skeleton.channel_count(); ++c)
    moves.places.push_back({skeleton.channel_joint(c), is_rotation(skeleton.channel_kind(c))});
  moves.axes.resize(original.frames(), 3 * static_cast<Eigen::Index>(skeleton.channel_count()));
  visit_poses(
      skeleton, original.channels,
      [&](const PoseBlock& poses, int first, int frames) {
        place_landmarks(origins, poses, first, frames, posed.origins);
        place_landmarks(points, poses, first, frames, posed.points);
      },
      &moves.axes);
  return posed;
}

ErrorModel::ErrorModel(const Skeleton& skeleton, const Clip& original, Weighting weighting)
    : ErrorModel(skeleton, original, measured_points(skeleton, weighting)) {}

ErrorModel::ErrorModel(const Skeleton& skeleton, const Clip& original,
                       const MeasuredPoints& measured)
    : ErrorModel(skeleton, measured, pose_channels(skeleton, original, measured.points)) {}

ErrorModel::ErrorModel(const Skeleton& skeleton, const Clip& original,
                       const MeasuredPoints& measured, SignalMoves moves)
    : ErrorModel(skeleton, measured,
                 Posed{std::move(moves), point_tracks(skeleton, joint_origins(skeleton), original),
                       point_tracks(skeleton, measured.points, original)}) {}

ErrorModel::ErrorModel(const Skeleton& skeleton, const MeasuredPoints& measured, const Posed& posed)
    : places_(posed.moves.places),
      above_(posed.moves.places.size()),
      below_(posed.moves.places.size()) {
  const auto joints = static_cast<std::size_t>(skeleton.joint_count());
  for (int j = 0; j < skeleton.joint_count(); ++j) parents_.push_back(skeleton.joint(j).parent);
  std::vector<std::vector<int>> joint_channels(joints);
  for (std::size_t c = 0; c < places_.size(); ++c)
    joint_channels[static_cast<std::size_t>(places_[c].joint)].push_back(static_cast<int>(c));
  for (std::size_t c = 0; c < places_.size(); ++c) {
    int joint = places_[c].joint;
    const auto& beside = joint_channels[static_cast<std::size_t>(joint)];
    below_[c].insert(below_[c].end(), beside.begin(), beside.end());
    while ((joint = skeleton.joint(joint).parent) >= 0)
      for (const int other : joint_channels[static_cast<std::size_t>(joint)]) {
        above_[c].push_back(other);
        below_[static_cast<std::size_t>(other)].push_back(static_cast<int>(c));
      }
  }
  is_moved_by_.resize(places_.size() * places_.size());
  for (std::size_t c = 0; c < places_.size(); ++c)
    for (const int other : below_[c])
      is_moved_by_[static_cast<std::size_t>(other) * places_.size() + c] = 1;
  compute_motions(skeleton, measured, posed);
}

void ErrorModel::compute_motions(const Skeleton& skeleton, const MeasuredPoints& measured,
                                 const Posed& posed) {
  const std::vector<Landmark>& points = measured.points;
  const Eigen::VectorXd& weights = measured.weights;
  assert(weights.size() == std::ssize(points));
  const SignalMoves& moves = posed.moves;
  const Eigen::Index rows = moves.axes.rows();
  origin_ = posed.origins.leftCols(3);
  const auto channels = static_cast<Eigen::Index>(moves.places.size());
  motions_.resize(rows, 6 * channels);
  forces_.resize(rows, 6 * channels);
  curvature_.resize(rows, channels);
  samples_ =
      Eigen::MatrixXf::Zero(2 * kVector * channels, (rows + kSampleEvery - 1) / kSampleEvery);
  const Eigen::Index blocks = (rows + kBlock - 1) / kBlock;
  parallel_for(Eigen::Index{0}, blocks, [&](Eigen::Index block) {
    const Eigen::Index first = block * kBlock;
    const auto frames = static_cast<int>(std::min(kBlock, rows - first));
    // Seen from the first joint, lest far places cost digits.
    const ThreeColumns origin = three_of(posed.origins, 0, first);
    std::vector<CompositeBody> bodies(static_cast<std::size_t>(skeleton.joint_count()));
    for (int p = 0; p < weights.size(); ++p)
      if (weights(p) > 0)
        bodies[static_cast<std::size_t>(points[static_cast<std::size_t>(p)].joint)].add(
            weights(p), three_of(posed.points, p, first), origin, frames);
    for (int j = skeleton.joint_count() - 1; j >= 0; --j)
      if (const int parent = skeleton.joint(j).parent; parent >= 0)
        bodies[static_cast<std::size_t>(parent)].add(bodies[static_cast<std::size_t>(j)], frames);

    for (int c = 0; c < static_cast<int>(channels); ++c) {
      const auto [joint, rotates] = moves.places[static_cast<std::size_t>(c)];
      const CompositeBody& body = bodies[static_cast<std::size_t>(joint)];
      const ThreeColumns axis = three_of(moves.axes, c, first);
      const ChannelResponse response{.motion = six_from(motions_, c, first),
                                     .force = six_from(forces_, c, first),
                                     .curvature = curvature_.col(c).data() + first};
      if (rotates)
        turn_body(body, axis, three_of(posed.origins, joint, first), origin, frames, response);
      else
        shift_body(body, axis, frames, response);
    }
    copy_samples(first, frames);
  });
}

bool ErrorModel::are_related(int a, int b) const {
  const int upper = places_[static_cast<std::size_t>(a)].joint;
  const int lower = places_[static_cast<std::size_t>(b)].joint;
  return moves(a, lower) || moves(b, upper);
}

Eigen::ArrayXf ErrorModel::entry(int a, int b) const {
  const bool a_is_upper = moves(a, places_[static_cast<std::size_t>(b)].joint);
  Eigen::ArrayXf work = Eigen::ArrayXf::Zero(frames());
  const Eigen::ArrayXf once = Eigen::ArrayXf::Ones(frames());
  add_work(six_of(forces_, a_is_upper ? b : a), six_of(motions_, a_is_upper ? a : b), once.data(),
           work.size(), work.data());
  return work;
}

void ErrorModel::copy_samples(Eigen::Index first, Eigen::Index frames) {
  const Eigen::Index first_sample = (first + kSampleEvery - 1) / kSampleEvery;
  const Eigen::Index end_sample = (first + frames + kSampleEvery - 1) / kSampleEvery;
  for (Eigen::Index k = first_sample; k < end_sample; ++k)
    for (int c = 0; c < channels(); ++c) {
      auto numbers = samples_.col(k).segment<2 * kVector>(2 * kVector * c);
      numbers.head<6>() = motions_.row(k * kSampleEvery).segment<6>(Eigen::Index{6} * c);
      numbers.segment<6>(kVector) = forces_.row(k * kSampleEvery).segment<6>(Eigen::Index{6} * c);
    }
}

void ErrorModel::sum_squares(const std::vector<int>& channels, const ShortFunction& function,
                             Eigen::MatrixXf& sums) const {
  constexpr Eigen::Index kSamples = 16;
  using Numbers = Eigen::Array<float, kVector, 1>;
  const auto to_next = [](Eigen::Index frame) {
    return (frame + kSampleEvery - 1) / kSampleEvery * kSampleEvery;
  };
  const Eigen::Index first = to_next(function.first());
  const Eigen::Index apart = std::max(to_next(function.size() / kSamples), kSampleEvery);
  const Eigen::Index samples =
      std::max<Eigen::Index>(function.end() - first + apart - 1, 0) / apart;
  const Eigen::ArrayXf weights =
      function.values()(Eigen::seqN(first - function.first(), samples, apart)).square();
  const auto count = std::ssize(channels);
  Eigen::MatrixXf motions(kVector * samples, count);
  Eigen::MatrixXf forces(kVector * samples, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = 2 * kVector * channels[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < samples; ++k) {
      const float* const numbers = samples_.col((first + k * apart) / kSampleEvery).data() + row;
      Eigen::Map<Numbers>(motions.col(i).data() + kVector * k) =
          weights(k) * Eigen::Map<const Numbers>(numbers);
      Eigen::Map<Numbers>(forces.col(i).data() + kVector * k) =
          Eigen::Map<const Numbers>(numbers + kVector);
    }
  }
  for (Eigen::Index lower = 0; lower < count; ++lower) {
    const auto below = static_cast<std::size_t>(channels[static_cast<std::size_t>(lower)]);
    for (Eigen::Index upper = 0; upper <= lower; ++upper) {
      const int above = channels[static_cast<std::size_t>(upper)];
      if (is_moved_by_[below * places_.size() + static_cast<std::size_t>(above)])
        sums(upper, lower) = sums(lower, upper) =
            inner_product(motions.col(upper).data(), forces.col(lower).data(), kVector * samples);
    }
  }
  for (const PointTerm& term : terms_) term.add_sums(channels, first, apart, weights, sums);
}

bool ErrorModel::moves(int channel, int joint) const {
  while (joint > places_[static_cast<std::size_t>(channel)].joint)
    joint = parents_[static_cast<std::size_t>(joint)];
  return joint == places_[static_cast<std::size_t>(channel)].joint;
}

Eigen::MatrixXd ErrorModel::velocity(int channel, const Eigen::MatrixXd& places) const {
  const Eigen::ArrayXXd motion = columns<6>(motions_, channel, 0, frames()).cast<double>();
  const auto turn = motion.leftCols<3>();
  const auto shift = motion.rightCols<3>();
  const Eigen::ArrayXXd arm = places - origin_;
  Eigen::MatrixXd moved(arm.rows(), 3);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    moved.col(i) = shift.col(i) + turn.col(j) * arm.col(k) - turn.col(k) * arm.col(j);
  }
  return moved;
}

void ErrorModel::add(const PointResponse& response) {
  PointTerm term(*this, response);
  term.add_curvature(curvature_);
  terms_.push_back(std::move(term));
}

/// The force that one channel calls up does work along the motion of the other: that of the lower
/// one is of all landmarks that both move.
template <typename Visit>
void ErrorModel::visit_related(int channel, const Visit& visit) const {
  const auto c = static_cast<std::size_t>(channel);
  for (const int other : below_[c]) visit(other, six_of(forces_, other), six_of(motions_, channel));
  for (const int other : above_[c]) visit(other, six_of(forces_, channel), six_of(motions_, other));
}

void ErrorModel::add_to_gradient(int channel, const Eigen::VectorXd& delta,
                                 Eigen::MatrixXd& gradient) const {
  for (const PointTerm& term : terms_) term.add_to_gradient(channel, delta, gradient);
  for (Eigen::Index first = 0; first < delta.size(); first += kBlock) {
    const Eigen::Index frames = std::min(kBlock, delta.size() - first);
    const Block<1, float> step = delta.segment(first, frames).cast<float>();
    if ((step == 0).all()) continue;
    visit_related(channel, [&](int other, const SixColumns& force, const SixColumns& motion) {
      Block<1, float> work = Block<1, float>::Zero(frames, 1);
      add_work(force.from(first), motion.from(first), step.data(), frames, work.data());
      gradient.col(other).segment(first, frames).array() += work.cast<double>();
    });
  }
}

ErrorState::ErrorState(const ErrorModel& model)
    : model_(&model), gradient_(Eigen::MatrixXd::Zero(model.frames(), model.channels())) {}

double ErrorState::change(int channel, const Eigen::VectorXd& delta) const {
  if (delta.size() == 0) return 0;
  return delta.dot(2 * gradient_.col(channel) +
                   model_->curvature().col(channel).cwiseProduct(delta)) /
         static_cast<double>(delta.size());
}

void ErrorState::add(int channel, const Eigen::VectorXd& delta) {
  squared_eps_ += change(channel, delta);
  model_->add_to_gradient(channel, delta, gradient_);
}

}  // namespace mocapress
