// SPDX-License-Identifier: MIT
#include "core/select/error_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <utility>

#include "core/base/parallel.h"
#include "core/motion/pose_block.h"
#include "core/select/composite_body.h"
#include "core/select/inner_product.h"

namespace mocapress {
namespace {

constexpr int kVector = 8;                               // numbers
constexpr Eigen::Index kSampleEvery = 2;                 // frames
constexpr Eigen::Index kBlock = CompositeBody::kFrames;  // frames at a time

/// The three columns of item `index` in a matrix of three columns an item, from frame `first` on.
ThreeColumns three_of(const Eigen::MatrixXd& matrix, int index, Eigen::Index first) {
  const double* const from = matrix.data() + Eigen::Index{3} * index * matrix.rows() + first;
  return {from, from + matrix.rows(), from + 2 * matrix.rows()};
}

/// The three numbers at a frame.
Eigen::Vector3d at(const ThreeColumns& columns, Eigen::Index frame) {
  return {columns[0][frame], columns[1][frame], columns[2][frame]};
}
Eigen::Vector3d at(const std::array<CompositeBody::Column, 3>& columns, Eigen::Index frame) {
  return at({columns[0].data(), columns[1].data(), columns[2].data()}, frame);
}

/// The inertia of a body about the origin: maps a small turn to the torque that it causes.
Eigen::Matrix3d inertia_of(const Eigen::Vector3d& square, const Eigen::Vector3d& mixed) {
  Eigen::Matrix3d inertia;
  inertia << square.y() + square.z(), -mixed.z(), -mixed.y(),  //
      -mixed.z(), square.z() + square.x(), -mixed.x(),         //
      -mixed.y(), -mixed.x(), square.x() + square.y();
  return inertia;
}

}  // namespace

/// The movements by the skeleton's own channels, about or along axes of unit length.
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

ErrorModel::ErrorModel(const Skeleton& skeleton, const MeasuredPoints& measured, Posed posed)
    : places_(posed.moves.places), origins_(std::move(posed.origins)) {
  int channel = 0;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    LinkageJoint joint{.parent = skeleton.joint(j).parent, .first_channel = channel, .turns = {}};
    for (; channel < std::ssize(places_) && places_[channel].joint == j; ++channel) {
      const bool turns = places_[channel].rotates;
      joint.turns.push_back(turns);
      joint.shifts = joint.shifts || !turns;
    }
    if (joint.parent >= 0) {
      linkage_[joint.parent].is_leaf = false;
      for (LinkageJoint& other : linkage_)
        if (other.parent == joint.parent) other.is_last_child = false;
    }
    linkage_.push_back(std::move(joint));
  }
  assert(channel == std::ssize(places_));
  is_moved_by_.resize(places_.size() * places_.size());
  for (std::size_t c = 0; c < places_.size(); ++c)
    for (std::size_t other = 0; other < places_.size(); ++other)
      is_moved_by_[c * places_.size() + other] = moves(static_cast<int>(other), places_[c].joint);
  compute_motions(skeleton, measured, posed.moves, posed.points);
}

void ErrorModel::compute_motions(const Skeleton& skeleton, const MeasuredPoints& measured,
                                 const SignalMoves& moves, const Eigen::MatrixXd& point_tracks) {
  const std::vector<Landmark>& points = measured.points;
  const Eigen::VectorXd& weights = measured.weights;
  assert(weights.size() == std::ssize(points));
  const Eigen::Index rows = moves.axes.rows();
  const auto channels = static_cast<Eigen::Index>(moves.places.size());
  const FrameRange all{0, rows};
  for (LinkageJoint& joint : linkage_) joint.numbers.resize(all.eights() * joint.stride());
  for (int p = 0; p < weights.size(); ++p)
    for (int j = points[p].joint; j >= 0; j = skeleton.joint(j).parent)
      linkage_[j].mass += static_cast<float>(std::max(weights(p), 0.0));
  curvature_.resize(rows, channels);
  samples_ =
      Eigen::MatrixXf::Zero(2 * kVector * ((rows + kSampleEvery - 1) / kSampleEvery), channels);
  const Eigen::Index blocks = (rows + kBlock - 1) / kBlock;
  parallel_for(Eigen::Index{0}, blocks, [&](Eigen::Index block) {
    const Eigen::Index first = block * kBlock;
    const auto frames = static_cast<int>(std::min(kBlock, rows - first));
    // Places are relative to the first joint, since those far from the origin would lose digits.
    const ThreeColumns origin = three_of(origins_, 0, first);
    std::vector<CompositeBody> bodies(skeleton.joint_count());
    for (int p = 0; p < weights.size(); ++p)
      if (weights(p) > 0)
        bodies[points[p].joint].add(weights(p), three_of(point_tracks, p, first), origin, frames);
    for (int j = skeleton.joint_count() - 1; j >= 0; --j)
      if (const int parent = skeleton.joint(j).parent; parent >= 0)
        bodies[parent].add(bodies[j], frames);
    for (int j = 0; j < skeleton.joint_count(); ++j)
      set_joint(j, bodies[j].seen_from(three_of(origins_, j, first), origin, frames), moves.axes,
                first, frames);
  });
}

void ErrorModel::set_joint(int j, const CompositeBody& body, const Eigen::MatrixXd& axes,
                           Eigen::Index first, Eigen::Index frames) {
  LinkageJoint& joint = linkage_[j];
  const ThreeColumns origin = three_of(origins_, j, first);
  const ThreeColumns parent = three_of(origins_, std::max(joint.parent, 0), first);
  const ThreeColumns root = three_of(origins_, 0, first);
  for (Eigen::Index t = 0; t < frames; ++t) {
    const Eigen::Vector3d place = at(origin, t);
    const Eigen::Vector3d moment = at(body.moment, t);
    const Eigen::Vector3d mixed = at(body.mixed, t);
    const Eigen::Matrix3d inertia = inertia_of(at(body.square, t), mixed);
    joint.set(first + t, LinkageJoint::kArm, place - at(parent, t));
    joint.set(first + t, LinkageJoint::kMoment, moment);
    joint.set(first + t, LinkageJoint::kInertia, inertia.diagonal());
    joint.set(first + t, LinkageJoint::kMixed, mixed);
    for (int c = joint.first_channel; c < joint.end_channel(); ++c) {
      const bool turns = places_[c].rotates;
      const Eigen::Vector3d axis = at(three_of(axes, c, first), t);
      const Eigen::Vector3d torque = turns ? inertia * axis : moment.cross(axis);
      const Eigen::Vector3d force = turns ? axis.cross(moment) : body.mass * axis;
      joint.set(first + t, joint.axis_of(c), axis);
      curvature_(first + t, c) = axis.dot(turns ? torque : force);
      if ((first + t) % kSampleEvery != 0) continue;
      const Eigen::Vector3d from_root = place - at(root, t);
      auto sample =
          samples_.col(c).segment<2 * kVector>(2 * kVector * ((first + t) / kSampleEvery));
      if (turns) sample.head<3>() = axis.cast<float>();
      sample.segment<3>(3) = (turns ? from_root.cross(axis) : axis).cast<float>();
      sample.segment<3>(kVector) = (torque + from_root.cross(force)).cast<float>();
      sample.segment<3>(kVector + 3) = force.cast<float>();
    }
  }
}

bool ErrorModel::are_related(int a, int b) const {
  const int upper = places_[a].joint;
  const int lower = places_[b].joint;
  return moves(a, lower) || moves(b, upper);
}

Eigen::ArrayXf ErrorModel::entry(int a, int b) const {
  const bool a_is_upper = moves(a, places_[b].joint);
  const int upper = a_is_upper ? a : b;
  const int lower = a_is_upper ? b : a;
  const FrameRange all{0, frames()};
  const Eigen::ArrayXf once = Eigen::ArrayXf::Ones(frames());
  std::vector<JointState> state(all.eights());
  std::vector<JointState> of_parent(state.size());
  const LinkageJoint* joint = &joint_of(lower);
  add_error(*joint, lower, once.data(), all, true, state.data());
  for (; joint != &joint_of(upper); joint = &linkage_[joint->parent]) {
    hand_up(*joint, all, state.data(), of_parent.data());
    state.swap(of_parent);
  }
  Eigen::ArrayXf work(EightFrames::kCount * all.eights());
  find_work(*joint, upper, all, state.data(), work.data());
  work.conservativeResize(frames());
  return work;
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
    const float* const of_channel = samples_.col(channels[i]).data();
    for (Eigen::Index k = 0; k < samples; ++k) {
      const float* const numbers = of_channel + 2 * kVector * ((first + k * apart) / kSampleEvery);
      Eigen::Map<Numbers>(motions.col(i).data() + kVector * k) =
          weights(k) * Eigen::Map<const Numbers>(numbers);
      Eigen::Map<Numbers>(forces.col(i).data() + kVector * k) =
          Eigen::Map<const Numbers>(numbers + kVector);
    }
  }
  for (Eigen::Index lower = 0; lower < count; ++lower) {
    const auto below = static_cast<std::size_t>(channels[lower]);
    for (Eigen::Index upper = 0; upper <= lower; ++upper) {
      const int above = channels[upper];
      if (is_moved_by_[below * places_.size() + static_cast<std::size_t>(above)])
        sums(upper, lower) = sums(lower, upper) =
            inner_product(motions.col(upper).data(), forces.col(lower).data(), kVector * samples);
    }
  }
  for (const PointTerm& term : terms_) term.add_sums(channels, first, apart, weights, sums);
}

bool ErrorModel::moves(int channel, int joint) const {
  const int own = places_[channel].joint;
  while (joint > own) joint = linkage_[joint].parent;
  return joint == own;
}

Eigen::MatrixXd ErrorModel::velocity(int channel, const Eigen::MatrixXd& places) const {
  const auto [j, rotates] = places_[channel];
  const LinkageJoint& joint = linkage_[j];
  Eigen::MatrixXd moved(places.rows(), 3);
  for (Eigen::Index t = 0; t < places.rows(); ++t) {
    const Eigen::RowVector3d axis = joint.at(t, joint.axis_of(channel)).transpose();
    const Eigen::RowVector3d arm = places.row(t) - origins_.block<1, 3>(t, Eigen::Index{3} * j);
    moved.row(t) = rotates ? Eigen::RowVector3d(axis.cross(arm)) : axis;
  }
  return moved;
}

void ErrorModel::add(const PointResponse& response) {
  PointTerm term(*this, response);
  term.add_curvature(curvature_);
  terms_.push_back(std::move(term));
}

void ErrorModel::find_gradient(const Eigen::MatrixXf& errors, Eigen::MatrixXf& gradient) const {
  // With this many frames at a time, numbers that are used again on the way from joint to joint and
  // back stay in the cache.
  constexpr Eigen::Index kTile = 64;
  constexpr Eigen::Index kFewTiles = 4;
  using State = std::array<JointState, kTile / EightFrames::kCount>;
  const FrameRange all{0, frames()};
  const ErrorColumns columns{errors.data(), errors.rows()};
  gradient.resize(EightFrames::kCount * all.eights(), channels());
  const Eigen::Index tiles = (frames() + kTile - 1) / kTile;
  parallel_ranges(Eigen::Index{0}, tiles, kFewTiles, [&](Eigen::Index tile, Eigen::Index end) {
    std::vector<State> states(linkage_.size());
    std::array<float, kTile> energies{};
    const auto state_of = [&](int joint) { return joint < 0 ? nullptr : states[joint].data(); };
    for (; tile < end; ++tile) {
      const FrameRange range{tile * kTile, std::min(kTile, frames() - tile * kTile)};
      for (int j = static_cast<int>(std::ssize(linkage_)) - 1; j >= 0; --j) {
        const LinkageJoint& joint = linkage_[j];
        hand_up(joint, columns, range, state_of(j), state_of(joint.parent), energies.data());
      }
      for (int j = 0; j < std::ssize(linkage_); ++j) {
        const LinkageJoint& joint = linkage_[j];
        enter(joint, columns, range, state_of(joint.parent), state_of(j));
        for (int c = joint.first_channel; c < joint.end_channel(); ++c)
          find_work(joint, c, range, state_of(j), gradient.col(c).data() + range.first);
      }
    }
  });
  for (const PointTerm& term : terms_) {
    const Eigen::MatrixXf forces = term.forces_of(errors);
    for (int c = 0; c < channels(); ++c)
      term.add_work(c, forces, gradient.col(c).head(frames()).array());
  }
}

void ErrorModel::add_to_gradient(int channel, const Eigen::VectorXd& delta,
                                 Eigen::MatrixXd& gradient) const {
  for (const PointTerm& term : terms_) term.add_to_gradient(channel, delta, gradient);
  constexpr Eigen::Index kTile = 128;
  using State = std::array<JointState, kTile / EightFrames::kCount>;
  const int own = places_[channel].joint;
  const auto states = std::make_unique_for_overwrite<State[]>(linkage_.size());
  for (Eigen::Index first = 0; first < delta.size(); first += kTile) {
    const FrameRange range{first, std::min(kTile, delta.size() - first)};
    const Eigen::ArrayXf step = delta.segment(first, range.count).cast<float>();
    if ((step == 0).all()) continue;
    const auto add_work_of = [&](int j) {
      const LinkageJoint& joint = linkage_[j];
      for (int c = joint.first_channel; c < joint.end_channel(); ++c) {
        std::array<float, kTile> work;
        find_work(joint, c, range, states[j].data(), work.data());
        gradient.col(c).segment(first, range.count) +=
            Eigen::Map<const Eigen::VectorXf>(work.data(), range.count).cast<double>();
      }
    };
    State& state = states[own];
    state = {};
    add_error(linkage_[own], channel, step.data(), range, true, state.data());
    add_work_of(own);
    // The force acts on all joints above, and the movement passes to all below.
    for (int j = own, parent; (parent = linkage_[j].parent) >= 0; j = parent) {
      hand_up(linkage_[j], range, states[j].data(), states[parent].data());
      add_work_of(parent);
    }
    for (int j = own + 1; j < std::ssize(linkage_); ++j) {
      if (!moves(channel, j)) continue;
      const LinkageJoint& joint = linkage_[j];
      State& moved = states[j];
      enter(joint, range, states[joint.parent].data(), moved.data());
      add_work_of(j);
    }
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
