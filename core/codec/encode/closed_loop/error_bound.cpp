// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/error_bound.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/motion/forward_kinematics.h"
#include "core/motion/skin_points.h"

namespace mocapress {
namespace {

std::vector<Landmark> bounded_points(const Skeleton& skeleton, Weighting weighting) {
  if (is_on_bones(weighting)) return landmarks(skeleton);
  std::vector<Landmark> points = joint_origins(skeleton);
  const std::vector<Landmark> measured = weighting == Weighting::Skin && skeleton.skin()
                                             ? corners_of(*skeleton.skin(), skeleton)
                                             : measured_points(skeleton, weighting).points;
  points.insert(points.end(), measured.begin(), measured.end());
  return points;
}

}  // namespace

ErrorBound::ErrorBound(const Motion& original, Weighting weighting, const Eigen::VectorXd& bound_cm)
    : skeleton_(original.skeleton),
      squared_bound_(bound_cm.array().square()),
      points_(bounded_points(original.skeleton, weighting)),
      original_tracks_(point_tracks(original.skeleton, points_, original.clip)) {}

void ErrorBound::begin(const Clip& decoded) {
  channels_ = decoded.channels;
  errors_ = point_tracks(skeleton_, points_, decoded) - original_tracks_;
  squared_.resize(errors_.rows(), std::ssize(points_));
  for (Eigen::Index p = 0; p < squared_.cols(); ++p)
    squared_.col(p) = errors_.middleCols<3>(3 * p).rowwise().squaredNorm();
  channel_ = -1;
  joint_ = -1;
  world_from_joint_.clear();
}

double ErrorBound::furthest() const {
  double furthest = 0;
  for (Eigen::Index p = 0; p < squared_.cols() && squared_.rows() > 0; ++p)
    furthest = std::max(furthest, (squared_.col(p).array() / squared_bound_).maxCoeff());
  return std::sqrt(furthest);
}

void ErrorBound::next() {
  ++channel_;
  while (joint_ < skeleton_.channel_joint(channel_)) enter_joint(joint_ + 1);
  // The joint's earlier rotations turn the axis of the current channel. Only the previous channel's
  // rotation is not in world_from_axes_ yet.
  const int before = channel_ - 1;
  if (before >= skeleton_.first_channel(joint_) && is_rotation(skeleton_.channel_kind(before)))
    for (std::size_t t = 0; t < world_from_axes_.size(); ++t)
      world_from_axes_[t] *=
          axis_rotation(axis_of(skeleton_.channel_kind(before)), channels_(t, before));
  find_moved();
}

/// Enters `joint`; the channels of the previous joint are final in this pass.
void ErrorBound::enter_joint(int joint) {
  const auto frames = static_cast<std::size_t>(channels_.rows());
  if (joint > 0) {
    const Joint& left = skeleton_.joint(joint - 1);
    Rotations world_from_left(frames, Eigen::Matrix3d::Identity());
    const auto count = static_cast<Eigen::Index>(left.channels.size());
    for (std::size_t t = 0; t < frames; ++t) {
      if (left.parent >= 0) world_from_left[t] = world_from_joint_[left.parent][t];
      if (count > 0)
        world_from_left[t] *= skeleton_.axes(joint - 1).parent_from_axes *
                              joint_rotation(left, channels_.row(t).segment(
                                                       skeleton_.first_channel(joint - 1), count)) *
                              skeleton_.axes(joint - 1).axes_from_joint;
    }
    world_from_joint_.push_back(std::move(world_from_left));
  }
  joint_ = joint;
  const Joint& entered = skeleton_.joint(joint);
  world_from_axes_.assign(frames, skeleton_.axes(joint).parent_from_axes);
  if (entered.parent < 0) return;
  const Rotations& world_from_parent = world_from_joint_[entered.parent];
  for (std::size_t t = 0; t < frames; ++t)
    world_from_axes_[t] = world_from_parent[t] * skeleton_.axes(joint).parent_from_axes;
}

void ErrorBound::find_moved() {
  moved_count_ = 0;
  const ChannelKind kind = skeleton_.channel_kind(channel_);
  const bool turns = is_rotation(kind);
  const int parent = skeleton_.joint(joint_).parent;
  const Eigen::Index frames = channels_.rows();
  Eigen::MatrixX3d axes(frames, 3);
  for (Eigen::Index t = 0; t < frames; ++t) {
    const auto frame = static_cast<std::size_t>(t);
    if (turns)
      axes.row(t) = world_from_axes_[frame].col(axis_of(kind));
    else if (parent < 0)
      axes.row(t) = Eigen::RowVector3d::Unit(axis_of(kind));
    else
      axes.row(t) = world_from_joint_[parent][frame].col(axis_of(kind));
  }
  const Eigen::MatrixX3d origin =
      original_tracks_.middleCols<3>(3 * joint_) + errors_.middleCols<3>(3 * joint_);
  moved_.resize(points_.size());
  for (Eigen::Index p = 0; p < std::ssize(points_); ++p) {
    if (!is_at_or_below(points_[p].joint, joint_)) continue;
    if (turns && p == joint_) continue;
    Moved& moved = moved_[moved_count_++];
    moved.landmark = p;
    moved.along.resize(frames, 3);
    moved.across.resize(turns ? frames : 0, 3);
    if (turns)
      find_way_of_turn({axes.data(), frames}, {origin.data(), frames},
                       {original_tracks_.col(3 * p).data(), frames}, frames, frames_of(moved, 0));
    else
      moved.along = axes;
  }
}

bool ErrorBound::is_at_or_below(int joint, int other) const {
  while (joint > other) joint = skeleton_.joint(joint).parent;
  return joint == other;
}

ErrorBound::Step ErrorBound::step_of(const Eigen::VectorXd& delta) const {
  if (!is_rotation(skeleton_.channel_kind(channel_))) return {delta, {}};
  return {delta.array().sin(), 1 - delta.array().cos()};
}

MovedFrames ErrorBound::frames_of(Moved& moved, Eigen::Index first_frame) {
  const auto columns = [&](double* numbers) -> Columns3<double> {
    return {numbers + first_frame, channels_.rows()};
  };
  return {columns(errors_.col(3 * moved.landmark).data()), columns(moved.along.data()),
          moved.across.size() > 0 ? columns(moved.across.data()) : Columns3<double>{},
          squared_.col(moved.landmark).data() + first_frame};
}

bool ErrorBound::allows(Eigen::Index first_frame, const Eigen::VectorXd& delta) {
  const Step step = step_of(delta);
  const double* const bound = squared_bound_.data() + first_frame;
  for (std::size_t i = 0; i < moved_count_; ++i) {
    if (!goes_beyond(frames_of(moved_[i], first_frame), step.of_frames(), bound)) continue;
    std::swap(moved_[i], moved_[i / 2]);  // moved up, so that the next check looks at it sooner
    return false;
  }
  return true;
}

void ErrorBound::add(Eigen::Index first_frame, const Eigen::VectorXd& delta) {
  const Step step = step_of(delta);
  channels_.col(channel_).segment(first_frame, delta.size()) += delta;
  for (std::size_t i = 0; i < moved_count_; ++i)
    move_point(frames_of(moved_[i], first_frame), step.of_frames());
}

}  // namespace mocapress
