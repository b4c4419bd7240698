// SPDX-License-Identifier: MIT
#include "core/formats/gltf_writer.h"

#include <Eigen/LU>
#include <algorithm>
#include <unordered_set>

#include "core/base/error.h"
#include "core/formats/gltf_animation.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/text_writer.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How each joint is placed against the one above it.
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

/// How the joints of a pose are placed one below the other, where some are scaled.
std::vector<LocalTransform> scaled_locals(const Skeleton& skeleton, const Pose& pose,
                                          const JointScales& scales, int frame,
                                          double cm_per_unit) {
  std::vector<LocalTransform> locals(static_cast<std::size_t>(skeleton.joint_count()));
  std::vector<NodePlacement> placements(locals.size());
  const NodePlacement world = file_placement(cm_per_unit, UpAxis::Y);
  for (std::size_t j = 0; j < locals.size(); ++j) {
    const int above = skeleton.joint(static_cast<int>(j)).parent;
    const NodePlacement& parent = above < 0 ? world : placements[static_cast<std::size_t>(above)];
    LocalTransform& local = locals[j];
    local.translation = parent.world_from_node.inverse() * (pose.origin[j] - parent.origin);
    local.rotation =
        (parent.rotation.conjugate() * Quaterniond(pose.world_from_joint[j])).normalized();
    local.scale = scales.at(j, frame);
    if (!local.translation.allFinite())
      throw WriteError("a joint is scaled to nothing: what hangs from it has no place in a glTF");
    placements[j] = below(parent, local);
  }
  return locals;
}

/// The tracks of all joints; the nodes are numbered as they are.
std::vector<NodeTrack> tracks_of(const Motion& motion, const Pose& rest, double cm_per_unit,
                                 const JointScales& scales) {
  const Skeleton& skeleton = motion.skeleton;
  std::vector<NodeTrack> tracks(static_cast<std::size_t>(skeleton.joint_count()));
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    NodeTrack& track = tracks[static_cast<std::size_t>(j)];
    track.node = static_cast<std::size_t>(j);
    track.rest = local_of(skeleton, rest, j, cm_per_unit);
  }
  if (scales.any()) {
    const std::vector<LocalTransform> rests = scaled_locals(skeleton, rest, scales, 0, cm_per_unit);
    for (std::size_t j = 0; j < tracks.size(); ++j) tracks[j].rest = rests[j];
  }
  Pose pose;
  for (int t = 0; t < motion.clip.frames(); ++t) {
    compute_pose(skeleton, motion.clip.channels.row(t), pose);
    if (scales.any()) {
      const std::vector<LocalTransform> locals =
          scaled_locals(skeleton, pose, scales, t, cm_per_unit);
      for (std::size_t j = 0; j < tracks.size(); ++j) {
        tracks[j].translation.push_back(locals[j].translation);
        tracks[j].rotation.push_back(locals[j].rotation);
        if (scales.has(j)) tracks[j].scales.push_back(locals[j].scale);
      }
      continue;
    }
    for (int j = 0; j < skeleton.joint_count(); ++j) {
      const LocalTransform local = local_of(skeleton, pose, j, cm_per_unit);
      tracks[static_cast<std::size_t>(j)].translation.push_back(local.translation);
      tracks[static_cast<std::size_t>(j)].rotation.push_back(local.rotation);
    }
  }
  return tracks;
}

/// The pose in which bones stand when nothing moves them.
Pose resting_pose(const Motion& motion, const SourceFormat& source) {
  const bool has_none =
      source.kind == SourceFormat::Kind::Fbx || source.kind == SourceFormat::Kind::Gltf;
  if (!has_none || motion.clip.frames() == 0) return rest_pose(motion.skeleton);
  Pose first;
  compute_pose(motion.skeleton, motion.clip.channels.row(0), first);
  return first;
}

/// joint_from_world at rest, column after column.
std::vector<float> inverse_bind_matrices(const Pose& rest, double cm_per_unit) {
  std::vector<float> values;
  for (std::size_t j = 0; j < rest.origin.size(); ++j) {
    Eigen::Matrix4d joint_from_world = Eigen::Matrix4d::Identity();
    joint_from_world.topLeftCorner<3, 3>() = rest.world_from_joint[j].transpose();
    joint_from_world.topRightCorner<3, 1>() =
        -rest.world_from_joint[j].transpose() * rest.origin[j] / cm_per_unit;
    for (const double value : joint_from_world.reshaped())
      values.push_back(static_cast<float>(value));
  }
  return values;
}

/// The nodes of a skeleton: its joints first, then where bones end.
Json nodes_of(const Skeleton& skeleton, const std::vector<NodeTrack>& tracks, double cm_per_unit) {
  const std::vector<std::string> names = gltf_names(skeleton);
  Json nodes = Json::array();
  // What the scales of a joint and of those above it do to where its bone ends.
  std::vector<NodePlacement> placements;
  const auto in_joint = [&](int j, const Vector3d& end_site) -> Vector3d {
    if (std::all_of(tracks.begin(), tracks.end(), [](const auto& t) { return t.scales.empty(); }))
      return end_site / cm_per_unit;
    const NodePlacement& placement = placements[static_cast<std::size_t>(j)];
    return placement.world_from_node.inverse() * (placement.rotation * end_site);
  };
  for (std::size_t j = 0; j < tracks.size(); ++j) {
    const int above = skeleton.joint(static_cast<int>(j)).parent;
    placements.push_back(below(above < 0 ? file_placement(cm_per_unit, UpAxis::Y)
                                         : placements[static_cast<std::size_t>(above)],
                               tracks[j].rest));
  }
  for (const NodeTrack& track : tracks) {
    nodes.push_back({{"name", names[track.node]}});
    set_transform(nodes.back(), track.rest);
  }
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    if (joint.parent >= 0) nodes[static_cast<std::size_t>(joint.parent)]["children"].push_back(j);
    if (!joint.end_site) continue;
    nodes[static_cast<std::size_t>(j)]["children"].push_back(nodes.size());
    nodes.push_back({{"name", names[static_cast<std::size_t>(j)] + "_end"},
                     {"translation", json_of(in_joint(j, *joint.end_site))}});
  }
  return nodes;
}

}  // namespace

SourceFormat gltf_format(const SourceFormat& source, const WriteOptions& options) {
  SourceFormat format{SourceFormat::Kind::Gltf, kGltfCmPerUnit};
  if (source.kind == SourceFormat::Kind::Gltf) format = source;
  format.cm_per_unit = options.cm_per_unit.value_or(format.cm_per_unit);
  format.up = options.up.value_or(format.up);
  return format;
}

std::vector<std::string> gltf_names(const Skeleton& skeleton) {
  std::vector<std::string> names;
  std::unordered_set<std::string> taken;
  for (const Joint& joint : skeleton.joints()) {
    // What is no UTF-8 becomes the sign for that, here as in the file.
    const std::string valid = parse_json("", dumped(joint.name)).get<std::string>();
    names.push_back(unique_word(valid.empty() ? "joint" : valid, taken));
  }
  return names;
}

std::string gltf_bytes(const Motion& given, GltfContainer container, const SourceFormat& source,
                       const WriteOptions& options, const ScalarTracks& scalars) {
  const SourceFormat format = gltf_format(source, options);
  const double cm_per_unit = format.cm_per_unit;
  const Motion motion = exported_motion(given, format, options);
  const Skeleton& skeleton = motion.skeleton;
  const Pose rest = resting_pose(motion, source);
  const std::vector<NodeTrack> tracks =
      tracks_of(motion, rest, cm_per_unit, JointScales(scalars, skeleton));

  Json nodes = nodes_of(skeleton, tracks, cm_per_unit);
  Json joints = Json::array();
  Json roots = Json::array();
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    joints.push_back(j);
    if (skeleton.joint(j).parent < 0) roots.push_back(j);
  }
  // The joints of a skin have a node above them all.
  if (roots.size() > 1) {
    nodes.push_back({{"name", "skeleton"}, {"children", roots}});
    roots = Json::array({nodes.size() - 1});
  }
  Json json = {{"asset", {{"version", "2.0"}, {"generator", "Mocapress"}}},
               {"scene", 0},
               {"scenes", Json::array({{{"nodes", roots}}})},
               {"nodes", nodes}};
  BufferWriter buffer(json, 0, "");
  const std::size_t matrices = buffer.add("MAT4", 16, inverse_bind_matrices(rest, cm_per_unit));
  json["skins"].push_back({{"inverseBindMatrices", matrices}, {"joints", joints}});
  Json animation = {{"samplers", Json::array()}, {"channels", Json::array()}};
  AnimationWriter writer(buffer, animation, 0, motion.clip.frames(), motion.clip.sample_rate_hz);
  for (const NodeTrack& track : tracks) writer.add(track, false);
  // Or else it would be no animation, and the number of frames be lost.
  if (animation["channels"].empty() && !tracks.empty()) writer.add(tracks.front(), true);
  json["animations"].push_back(std::move(animation));
  return in_container(std::move(json), container, 0, buffer.release());
}

}  // namespace mocapress
