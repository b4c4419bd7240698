// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6 (composite rigid
// bodies).
#include "core/select/error_model.h"

#include <algorithm>
#include <cassert>

#include "core/base/parallel.h"
#include "core/motion/pose_block.h"

namespace mocapress {
namespace {

constexpr Eigen::Index kBlock = 64;  // frames at a time: what is in flight stays in the first cache

/// Some numbers for each frame of a block.
template <int count, typename Number = double>
using Block = Eigen::Array<Number, Eigen::Dynamic, count, Eigen::ColMajor, kBlock, count>;

/// Columns count * index ... of a matrix with as many a thing.
template <int count, typename Matrix>
auto columns(const Matrix& matrix, int index, Eigen::Index first, Eigen::Index frames) {
  return matrix.block(first, static_cast<Eigen::Index>(index) * count, frames, count).array();
}

Block<3> cross(const Block<3>& a, const Block<3>& b) {
  Block<3> product(a.rows(), 3);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    product.col(i) = a.col(j) * b.col(k) - a.col(k) * b.col(j);
  }
  return product;
}

/// Weighted landmarks that move as one: the sums of w, w x (3) and of w x x^T (xx yy zz yz zx xy).
struct Inertia {
  double mass = 0;
  Block<3> moment;
  Block<6> square;

  static Inertia none(Eigen::Index frames) {
    return {0, Block<3>::Zero(frames, 3), Block<6>::Zero(frames, 6)};
  }
  void add(double weight, const Block<3>& place) {
    mass += weight;
    moment += weight * place;
    for (int i = 0; i < 3; ++i) {
      square.col(i) += weight * place.col(i).square();
      square.col(3 + i) += weight * place.col((i + 1) % 3) * place.col((i + 2) % 3);
    }
  }
  void add(const Inertia& other) {
    mass += other.mass;
    moment += other.moment;
    square += other.square;
  }

  /// Of the displacement v + w x x: the sum of forces, and of their moments about the origin.
  Block<3> force(const Block<3>& w, const Block<3>& v) const { return mass * v + cross(w, moment); }
  Block<3> torque(const Block<3>& w, const Block<3>& v) const {
    Block<3> sum = cross(moment, v);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      sum.col(i) += (square.col(j) + square.col(k)) * w.col(i) - square.col(3 + k) * w.col(j) -
                    square.col(3 + j) * w.col(k);
    }
    return sum;
  }
};

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
  const Eigen::Index blocks = (rows + kBlock - 1) / kBlock;
  parallel_for(Eigen::Index{0}, blocks, [&](Eigen::Index block) {
    const Eigen::Index first = block * kBlock;
    const Eigen::Index frames = std::min(kBlock, rows - first);
    // Seen from the first joint, lest far places cost digits.
    const auto place = [&](const Eigen::MatrixXd& tracks, int index) -> Block<3> {
      return columns<3>(tracks, index, first, frames) - columns<3>(posed.origins, 0, first, frames);
    };
    std::vector<Inertia> inertias(static_cast<std::size_t>(skeleton.joint_count()),
                                  Inertia::none(frames));
    for (int p = 0; p < weights.size(); ++p)
      if (weights(p) > 0)
        inertias[static_cast<std::size_t>(points[static_cast<std::size_t>(p)].joint)].add(
            weights(p), place(posed.points, p));
    for (int j = skeleton.joint_count() - 1; j >= 0; --j)
      if (const int parent = skeleton.joint(j).parent; parent >= 0)
        inertias[static_cast<std::size_t>(parent)].add(inertias[static_cast<std::size_t>(j)]);

    for (int c = 0; c < static_cast<int>(channels); ++c) {
      const auto [joint, rotates] = moves.places[static_cast<std::size_t>(c)];
      const Inertia& inertia = inertias[static_cast<std::size_t>(joint)];
      const Block<3> axis = columns<3>(moves.axes, c, first, frames);
      const Block<3> still = Block<3>::Zero(frames, 3);
      const Block<3> turn = rotates ? axis : still;
      const Block<3> shift = rotates ? cross(place(posed.origins, joint), axis) : axis;
      Block<6> motion(frames, 6);
      Block<6> force(frames, 6);
      motion << turn, shift;
      force << inertia.torque(turn, shift), inertia.force(turn, shift);
      motions_.block(first, Eigen::Index{6} * c, frames, 6) = motion.cast<float>();
      forces_.block(first, Eigen::Index{6} * c, frames, 6) = force.cast<float>();
      curvature_.col(c).segment(first, frames) = (motion * force).rowwise().sum().matrix();
    }
  });
}

bool ErrorModel::are_related(int a, int b) const {
  const int upper = places_[static_cast<std::size_t>(a)].joint;
  const int lower = places_[static_cast<std::size_t>(b)].joint;
  return moves(a, lower) || moves(b, upper);
}

Eigen::VectorXf ErrorModel::entry(int a, int b) const {
  const bool a_is_upper = moves(a, places_[static_cast<std::size_t>(b)].joint);
  const int upper = a_is_upper ? a : b;
  const int lower = a_is_upper ? b : a;
  return motions_.middleCols(Eigen::Index{6} * upper, 6)
      .cwiseProduct(forces_.middleCols(Eigen::Index{6} * lower, 6))
      .rowwise()
      .sum();
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

void ErrorModel::add_to_gradient(int channel, const Eigen::VectorXd& delta,
                                 Eigen::MatrixXd& gradient) const {
  for (const PointTerm& term : terms_) term.add_to_gradient(channel, delta, gradient);
  for (Eigen::Index first = 0; first < delta.size(); first += kBlock) {
    const auto step = delta.segment(first, std::min(kBlock, delta.size() - first));
    if (!step.isZero(0))
      spread(channel, first, step.cast<float>().array(), {0, channels()}, gradient);
  }
}

void ErrorModel::add_to_gradient(int channel, Eigen::Index first_frame,
                                 const Eigen::Ref<const Eigen::ArrayXf>& delta,
                                 const ChannelRange& channels, Eigen::MatrixXf& gradient) const {
  spread(channel, first_frame, delta, channels, gradient);
}

template <typename Gradient>
void ErrorModel::spread(int channel, Eigen::Index first_frame,
                        const Eigen::Ref<const Eigen::ArrayXf>& delta, const ChannelRange& channels,
                        Gradient& gradient) const {
  const auto c = static_cast<std::size_t>(channel);
  for (Eigen::Index done = 0; done < delta.size(); done += kBlock) {
    const Eigen::Index first = first_frame + done;
    const Eigen::Index frames = std::min(kBlock, delta.size() - done);
    const auto step = delta.segment(done, frames);
    // The force that one channel calls up does work along the motion of the other: that of the
    // lower one is of all landmarks that both move.
    const auto add = [&](const Block<6, float>& mine, const Eigen::MatrixXf& theirs, int other) {
      if (!channels.has(other)) return;
      const auto them = columns<6>(theirs, other, first, frames);
      const Block<1, float> work = mine.col(0) * them.col(0) + mine.col(1) * them.col(1) +
                                   mine.col(2) * them.col(2) + mine.col(3) * them.col(3) +
                                   mine.col(4) * them.col(4) + mine.col(5) * them.col(5);
      gradient.col(other).segment(first, frames).array() +=
          work.template cast<typename Gradient::Scalar>();
    };
    const Block<6, float> motion = columns<6>(motions_, channel, first, frames).colwise() * step;
    for (const int other : below_[c]) add(motion, forces_, other);
    const Block<6, float> force = columns<6>(forces_, channel, first, frames).colwise() * step;
    for (const int other : above_[c]) add(force, motions_, other);
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
