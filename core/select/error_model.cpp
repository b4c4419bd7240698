// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 5 (the inward pass).
#include "core/select/error_model.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/parallel.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

constexpr Eigen::Index kBlock = 64;  // frames at a time: what is in flight stays in the first cache

/// A 3-vector for each frame of a block, one array a coordinate.
struct VectorBlock {
  using Values = Eigen::Array<double, Eigen::Dynamic, 1, 0, kBlock, 1>;
  std::array<Values, 3> at;

  static VectorBlock zero(Eigen::Index frames) {
    return {{Values::Zero(frames), Values::Zero(frames), Values::Zero(frames)}};
  }
  /// Columns 3 * index ... of a frames x 3 * count matrix.
  static VectorBlock of(const Eigen::MatrixXd& matrix, int index, Eigen::Index first,
                        Eigen::Index frames) {
    const auto column = [&](int axis) {
      return matrix.col(3 * static_cast<Eigen::Index>(index) + axis).segment(first, frames).array();
    };
    return {{column(0), column(1), column(2)}};
  }
  VectorBlock operator-(const VectorBlock& b) const {
    return {{at[0] - b.at[0], at[1] - b.at[1], at[2] - b.at[2]}};
  }
  VectorBlock& operator+=(const VectorBlock& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += b.at[axis];
    return *this;
  }
  VectorBlock& operator*=(const Values& factor) {
    for (auto& values : at) values *= factor;
    return *this;
  }
  VectorBlock cross(const VectorBlock& b) const {
    return {{at[1] * b.at[2] - at[2] * b.at[1], at[2] * b.at[0] - at[0] * b.at[2],
             at[0] * b.at[1] - at[1] * b.at[0]}};
  }
  Values dot(const VectorBlock& b) const {
    return at[0] * b.at[0] + at[1] * b.at[1] + at[2] * b.at[2];
  }
};

/// Force and moment (about the world's origin) summed over the landmarks of a subtree.
struct Wrench {
  VectorBlock force;
  VectorBlock moment;
};

/// Of the skeleton's own channels: unit axes.
SignalMoves channel_moves(const Skeleton& skeleton, const Clip& original) {
  SignalMoves moves;
  for (int c = 0; c < skeleton.channel_count(); ++c)
    moves.places.push_back({skeleton.channel_joint(c), is_rotation(skeleton.channel_kind(c))});
  moves.axes.resize(original.frames(), 3 * static_cast<Eigen::Index>(skeleton.channel_count()));
  parallel_ranges(0, original.frames(), 64, [&](int first, int end) {
    Pose pose;
    for (int t = first; t < end; ++t) {
      compute_pose(skeleton, original.channels.row(t), pose);
      for (int j = 0; j < skeleton.joint_count(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const Eigen::Matrix3d world_from_parent =
            joint.parent < 0 ? Eigen::Matrix3d::Identity()
                             : pose.world_from_joint[static_cast<std::size_t>(joint.parent)];
        Eigen::Matrix3d world_from_axes = world_from_parent * joint.joint_from_axes;
        for (std::size_t i = 0; i < joint.channels.size(); ++i) {
          const int channel = skeleton.first_channel(j) + static_cast<int>(i);
          const int axis = axis_of(joint.channels[i]);
          const bool rotates = is_rotation(joint.channels[i]);
          moves.axes.block<1, 3>(t, 3 * static_cast<Eigen::Index>(channel)) =
              (rotates ? world_from_axes : world_from_parent).col(axis).transpose();
          if (rotates) world_from_axes *= axis_rotation(axis, original.channels(t, channel));
        }
      }
    }
  });
  return moves;
}

}  // namespace

ErrorModel::ErrorModel(const Skeleton& skeleton, const Clip& original, Weighting weighting)
    : ErrorModel(skeleton, original, landmark_weights(skeleton, weighting)) {}

ErrorModel::ErrorModel(const Skeleton& skeleton, const Clip& original,
                       const Eigen::VectorXd& weights)
    : ErrorModel(skeleton, original, weights, channel_moves(skeleton, original)) {}

ErrorModel::ErrorModel(const Skeleton& skeleton, const Clip& original,
                       const Eigen::VectorXd& weights, SignalMoves moves)
    : places_(std::move(moves.places)),
      weights_(weights),
      tracks_(landmark_tracks(skeleton, original)),
      axes_(std::move(moves.axes)) {
  const auto joints = static_cast<std::size_t>(skeleton.joint_count());
  subtrees_.resize(joints);
  joint_channels_.resize(joints);
  joint_landmarks_.resize(joints);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    parents_.push_back(skeleton.joint(j).parent);
    for (int root = j; root >= 0; root = skeleton.joint(root).parent)
      subtrees_[static_cast<std::size_t>(root)].push_back(j);
  }
  for (std::size_t c = 0; c < places_.size(); ++c)
    joint_channels_[static_cast<std::size_t>(places_[c].joint)].push_back(static_cast<int>(c));
  const std::vector<Landmark> points = landmarks(skeleton);
  assert(weights.size() == static_cast<Eigen::Index>(points.size()));
  for (int p = 0; p < weights.size(); ++p)
    if (weights(p) > 0)
      joint_landmarks_[static_cast<std::size_t>(points[static_cast<std::size_t>(p)].joint)]
          .push_back(p);
  compute_curvature();
}

void ErrorModel::compute_curvature() {
  const auto channels = static_cast<int>(places_.size());
  curvature_ = Eigen::MatrixXd::Zero(axes_.rows(), channels);
  parallel_for(0, channels, [&](int c) {
    const auto [joint, rotates] = places_[static_cast<std::size_t>(c)];
    for (Eigen::Index first = 0; first < axes_.rows(); first += kBlock) {
      const Eigen::Index frames = std::min(kBlock, axes_.rows() - first);
      const VectorBlock axis = VectorBlock::of(axes_, c, first, frames);
      const VectorBlock origin = VectorBlock::of(tracks_, joint, first, frames);
      auto sum = curvature_.col(c).segment(first, frames).array();
      for (const int below : subtrees_[static_cast<std::size_t>(joint)])
        for (const int p : joint_landmarks_[static_cast<std::size_t>(below)]) {
          const VectorBlock arm = VectorBlock::of(tracks_, p, first, frames) - origin;
          const VectorBlock way = rotates ? axis.cross(arm) : axis;
          sum += weights_(p) * way.dot(way);
        }
    }
  });
}

void ErrorModel::add_to_gradient(int channel, const Eigen::VectorXd& delta,
                                 Eigen::MatrixXd& gradient) const {
  const auto [joint, rotates] = places_[static_cast<std::size_t>(channel)];
  const std::vector<int>& subtree = subtrees_[static_cast<std::size_t>(joint)];
  std::vector<Wrench> wrenches(parents_.size());
  for (Eigen::Index first = 0; first < axes_.rows(); first += kBlock) {
    const Eigen::Index frames = std::min(kBlock, axes_.rows() - first);
    const auto project = [&](int on_joint, const Wrench& wrench) {
      const VectorBlock origin = VectorBlock::of(tracks_, on_joint, first, frames);
      const VectorBlock moment_at_origin = wrench.moment - origin.cross(wrench.force);
      for (const int c : joint_channels_[static_cast<std::size_t>(on_joint)]) {
        const VectorBlock axis = VectorBlock::of(axes_, c, first, frames);
        const bool turns = places_[static_cast<std::size_t>(c)].rotates;
        gradient.col(c).segment(first, frames).array() +=
            axis.dot(turns ? moment_at_origin : wrench.force);
      }
    };

    VectorBlock motion = VectorBlock::of(axes_, channel, first, frames);
    motion *= VectorBlock::Values(delta.segment(first, frames).array());
    const VectorBlock center = VectorBlock::of(tracks_, joint, first, frames);
    for (const int j : subtree)
      wrenches[static_cast<std::size_t>(j)] = {VectorBlock::zero(frames),
                                               VectorBlock::zero(frames)};
    for (auto j = subtree.rbegin(); j != subtree.rend(); ++j) {
      Wrench& wrench = wrenches[static_cast<std::size_t>(*j)];
      for (const int p : joint_landmarks_[static_cast<std::size_t>(*j)]) {
        const VectorBlock position = VectorBlock::of(tracks_, p, first, frames);
        VectorBlock force = rotates ? motion.cross(position - center) : motion;
        force *= VectorBlock::Values::Constant(frames, weights_(p));
        wrench.force += force;
        wrench.moment += position.cross(force);
      }
      project(*j, wrench);
      if (*j == joint) continue;
      Wrench& above = wrenches[static_cast<std::size_t>(parents_[static_cast<std::size_t>(*j)])];
      above.force += wrench.force;
      above.moment += wrench.moment;
    }
    for (int j = parents_[static_cast<std::size_t>(joint)]; j >= 0;
         j = parents_[static_cast<std::size_t>(j)])
      project(j, wrenches[static_cast<std::size_t>(joint)]);
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
