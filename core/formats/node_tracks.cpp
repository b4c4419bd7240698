// SPDX-License-Identifier: MIT
#include "core/formats/node_tracks.h"

#include <Eigen/LU>
#include <algorithm>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/printable.h"

namespace mocapress {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The transform of a joint relative to its parent.
LocalTransform local_of(const Skeleton& skeleton, const Pose& pose, int joint, double cm_per_unit) {
  const auto j = static_cast<std::size_t>(joint);
  const int parent = skeleton.joint(joint).parent;
  LocalTransform local;
  if (parent < 0) {
    local.translation = pose.origin[j] / cm_per_unit;
    local.rotation = Quaterniond(pose.world_from_joint[j]).normalized();
    return local;
  }
  const auto p = static_cast<std::size_t>(parent);
  const Eigen::Matrix3d parent_from_world = pose.world_from_joint[p].transpose();
  local.translation = parent_from_world * (pose.origin[j] - pose.origin[p]) / cm_per_unit;
  local.rotation = Quaterniond(parent_from_world * pose.world_from_joint[j]).normalized();
  return local;
}

/// The transforms of all joints relative to their parents, in a pose where some are scaled.
std::vector<LocalTransform> scaled_locals(const Skeleton& skeleton, const Pose& pose,
                                          const JointScales& scales, int frame,
                                          double cm_per_unit) {
  std::vector<LocalTransform> locals(skeleton.joint_count());
  std::vector<NodePlacement> placements(locals.size());
  const NodePlacement world = file_placement(cm_per_unit, UpAxis::Y);
  for (std::size_t j = 0; j < locals.size(); ++j) {
    const int above = skeleton.joint(static_cast<int>(j)).parent;
    const NodePlacement& parent = above < 0 ? world : placements[above];
    LocalTransform& local = locals[j];
    local.translation = parent.world_from_node.inverse() * (pose.origin[j] - parent.origin);
    local.rotation =
        (parent.rotation.conjugate() * Quaterniond(pose.world_from_joint[j])).normalized();
    local.scale = scales.at(j, frame);
    if (!local.translation.allFinite())
      throw WriteError("a joint is scaled to nothing: what hangs from it has no place");
    placements[j] = below(parent, local);
  }
  return locals;
}

/// The transforms of all joints relative to their parents, scaled or not.
std::vector<LocalTransform> locals_of(const Skeleton& skeleton, const Pose& pose,
                                      const JointScales& scales, int frame, double cm_per_unit) {
  if (scales.any()) return scaled_locals(skeleton, pose, scales, frame, cm_per_unit);
  std::vector<LocalTransform> locals;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    locals.push_back(local_of(skeleton, pose, j, cm_per_unit));
  return locals;
}

/// Moves the nodes of a source file as the joints of a motion move.
class SourceTracks {
 public:
  SourceTracks(const std::string& file, const NodeTake& take, const ReadOptions& options)
      : file_(file), take_(take), joint_of_node_(take_.nodes.size(), -1) {
    for (std::size_t n = 0; n < take.nodes.size(); ++n)
      tracks_.push_back({.node = n, .rest = take.nodes[n].rest});
    above_all_ = file_placement(options.cm_per_unit.value_or(take_.cm_per_unit),
                                options.up.value_or(take_.up));
  }

  /// The tracks of the nodes that are joints of `motion`, one for each.
  std::vector<NodeTrack> follow(const Motion& motion, const std::vector<std::string>& names,
                                const ReadOptions& options, const JointScales& scales) {
    find_nodes(names, options);
    Pose pose;
    for (int t = 0; t < motion.clip.frames(); ++t) {
      compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
      place(pose, scales, t);
    }
    std::vector<NodeTrack> tracks;
    for (std::size_t n = 0; n < tracks_.size(); ++n) {
      if (joint_of_node_[n] < 0) continue;
      // Keeps the scale that still() used to place the node, if no track says how it changes.
      if (const Vector3d scale = still(n).scale;
          tracks_[n].scales.empty() && !scale.isApprox(tracks_[n].rest.scale, 1e-6))
        tracks_[n].scale = scale;
      tracks.push_back(std::move(tracks_[n]));
    }
    return tracks;
  }

 private:
  void find_nodes(const std::vector<std::string>& names, const ReadOptions& options) {
    const std::vector<std::size_t> nodes = nodes_of_joints(file_, take_);
    const Skeleton own = motion_of(file_, take_, options, SourceFormat::Kind::None).motion.skeleton;
    std::unordered_map<std::string, std::size_t> node_of_name;
    for (int j = 0; j < own.joint_count(); ++j) node_of_name.emplace(own.joint(j).name, nodes[j]);
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto found = node_of_name.find(names[j]);
      if (found == node_of_name.end())
        throw InputError(file_, 0, 0,
                         "has no joint " + shortened(names[j]) + ", which the motion has");
      joint_of_node_[found->second] = static_cast<int>(j);
    }
  }

  /// The transform of a node that does not follow the motion: that of the reader's first frame.
  LocalTransform still(std::size_t node) const {
    const AnimatedNode& of = take_.nodes[node];
    return of.frames.empty() ? of.rest : of.frames.front();
  }

  /// Places all nodes for one frame. A node that follows a joint gets the transform, relative to
  /// its parent, that brings it to the joint's place in the world.
  void place(const Pose& pose, const JointScales& scales, int frame) {
    placements_.resize(tracks_.size());
    for (std::size_t n = 0; n < tracks_.size(); ++n) {
      const int above = take_.nodes[n].parent;
      const NodePlacement& parent = above < 0 ? above_all_ : placements_[above];
      LocalTransform local = still(n);
      if (joint_of_node_[n] >= 0) {
        const auto j = static_cast<std::size_t>(joint_of_node_[n]);
        local.translation = parent.world_from_node.inverse() * (pose.origin[j] - parent.origin);
        local.rotation = parent.rotation.conjugate() * Quaterniond(pose.world_from_joint[j]);
        if (!local.translation.allFinite())
          throw InputError(file_, 0, 0,
                           "scales " + shortened(take_.nodes[n].name) +
                               " to nothing: it cannot follow a motion");
        tracks_[n].translation.push_back(local.translation);
        tracks_[n].rotation.push_back(local.rotation);
        if (scales.has(j)) {
          local.scale = scales.at(j, frame);
          tracks_[n].scales.push_back(local.scale);
        }
      }
      placements_[n] = below(parent, local);
    }
  }

  const std::string& file_;
  const NodeTake& take_;
  std::vector<int> joint_of_node_;  // -1: the node follows no joint
  std::vector<NodeTrack> tracks_;   // one for each node
  std::vector<NodePlacement> placements_;
  NodePlacement above_all_;
};

}  // namespace

JointScales::JointScales(const ScalarTracks& tracks, const Skeleton& skeleton)
    : of_joint_(static_cast<std::size_t>(skeleton.joint_count())) {
  for (const ScalarTrack& track : tracks) {
    const int joint = is_scale(track.kind) ? skeleton.find(track.node) : -1;
    if (joint < 0) continue;
    const auto axis =
        static_cast<std::size_t>(track.kind) - static_cast<std::size_t>(TrackKind::ScaleX);
    of_joint_[joint][axis] = &track;
    any_ = true;
  }
}

bool JointScales::has(std::size_t joint) const {
  const auto& of = of_joint_[joint];
  return std::ranges::any_of(of, [](const auto* track) { return track != nullptr; });
}

Vector3d JointScales::at(std::size_t joint, int frame) const {
  Vector3d scale = Vector3d::Ones();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const ScalarTrack* const track = of_joint_[joint][axis])
      scale(axis) = static_cast<double>(track->values[frame]);
  return scale;
}

Pose resting_pose(const Motion& motion, const SourceFormat& source) {
  const bool has_none =
      source.kind == SourceFormat::Kind::Fbx || source.kind == SourceFormat::Kind::Gltf;
  if (!has_none || motion.clip.frames() == 0) return rest_pose(motion.skeleton);
  Pose first;
  compute_pose(motion.skeleton, motion.clip.channels.row(0), first);
  return first;
}

std::vector<NodeTrack> tracks_of(const Motion& motion, const Pose& rest, double cm_per_unit,
                                 const JointScales& scales) {
  const Skeleton& skeleton = motion.skeleton;
  std::vector<NodeTrack> tracks;
  for (const LocalTransform& local : locals_of(skeleton, rest, scales, 0, cm_per_unit))
    tracks.push_back({.node = tracks.size(), .rest = local});
  Pose pose;
  for (int t = 0; t < motion.clip.frames(); ++t) {
    compute_pose(skeleton, motion.clip.channels.row(t), pose);
    const std::vector<LocalTransform> locals = locals_of(skeleton, pose, scales, t, cm_per_unit);
    for (std::size_t j = 0; j < tracks.size(); ++j) {
      tracks[j].translation.push_back(locals[j].translation);
      tracks[j].rotation.push_back(locals[j].rotation);
      if (scales.has(j)) tracks[j].scales.push_back(locals[j].scale);
    }
  }
  return tracks;
}

std::vector<NodePlacement> rest_placements(const Skeleton& skeleton,
                                           const std::vector<NodeTrack>& tracks,
                                           double cm_per_unit) {
  std::vector<NodePlacement> placements;
  for (std::size_t j = 0; j < tracks.size(); ++j) {
    const int above = skeleton.joint(static_cast<int>(j)).parent;
    placements.push_back(below(
        above < 0 ? file_placement(cm_per_unit, UpAxis::Y) : placements[above], tracks[j].rest));
  }
  return placements;
}

Vector3d end_in_node(const NodePlacement& node, const Vector3d& end_site) {
  return node.world_from_node.inverse() * (node.rotation * end_site);
}

std::vector<NodeTrack> tracks_following(const std::string& file, const NodeTake& take,
                                        const Motion& motion, const std::vector<std::string>& names,
                                        const ReadOptions& options, const JointScales& scales) {
  return SourceTracks(file, take, options).follow(motion, names, options, scales);
}

}  // namespace mocapress
