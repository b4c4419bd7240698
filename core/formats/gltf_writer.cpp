// SPDX-License-Identifier: MIT
#include "core/formats/gltf_writer.h"

#include <unordered_set>

#include "core/base/error.h"
#include "core/formats/gltf_animation.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/node_tracks.h"
#include "core/formats/text_writer.h"

namespace mocapress {
namespace {

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

/// The nodes of a skeleton: first its joints, then the ends of bones.
Json nodes_of(const Skeleton& skeleton, const std::vector<NodeTrack>& tracks, double cm_per_unit) {
  const std::vector<std::string> names = gltf_names(skeleton);
  Json nodes = Json::array();
  const std::vector<NodePlacement> placements = rest_placements(skeleton, tracks, cm_per_unit);
  for (const NodeTrack& track : tracks) {
    nodes.push_back({{"name", names[track.node]}});
    set_transform(nodes.back(), track.rest);
  }
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    if (joint.parent >= 0) nodes[joint.parent]["children"].push_back(j);
    if (!joint.end_site) continue;
    nodes[j]["children"].push_back(nodes.size());
    nodes.push_back({{"name", names[j] + "_end"},
                     {"translation", json_of(end_in_node(placements[j], *joint.end_site))}});
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
    // Bytes that are not UTF-8 become the replacement character, here as in the file.
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
  // glTF requires one node above all joints of a skin.
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
  // An animation needs a channel, even if nothing moves: it also tells the number of frames.
  if (animation["channels"].empty() && !tracks.empty()) writer.add(tracks.front(), true);
  json["animations"].push_back(std::move(animation));
  return in_container(std::move(json), container, 0, buffer.release());
}

}  // namespace mocapress
