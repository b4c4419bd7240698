// SPDX-License-Identifier: MIT
#include "core/formats/gltf_writer.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/base/file.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/text_writer.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr const char* kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr int kFloat = 5126;  // componentType
constexpr const char* kDataUri = "data:application/octet-stream;base64,";

std::string base64_of(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t held = std::min<std::size_t>(3, bytes.size() - i);
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < held ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= held ? kBase64[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

/// A node's movement against its parent, in the file's unit.
struct NodeTrack {
  std::size_t node = 0;  // its index in the file
  LocalTransform rest;
  std::vector<Vector3d> translation;
  std::vector<Quaterniond> rotation;
  std::optional<Vector3d> scale;  // where it is another than at rest
  std::vector<Vector3d> scales;   // where it changes
};

/// The scales that tracks have of joints.
class JointScales {
 public:
  JointScales(const ScalarTracks& tracks, const Skeleton& skeleton)
      : of_joint_(static_cast<std::size_t>(skeleton.joint_count())) {
    for (const ScalarTrack& track : tracks) {
      const int joint = is_scale(track.kind) ? skeleton.find(track.node) : -1;
      if (joint < 0) continue;
      const auto axis =
          static_cast<std::size_t>(track.kind) - static_cast<std::size_t>(TrackKind::ScaleX);
      of_joint_[static_cast<std::size_t>(joint)][axis] = &track;
      any_ = true;
    }
  }

  bool any() const { return any_; }
  bool has(std::size_t joint) const {
    const auto& of = of_joint_[joint];
    return std::any_of(of.begin(), of.end(), [](const auto* track) { return track != nullptr; });
  }
  /// Along axes without a track it is 1.
  Vector3d at(std::size_t joint, int frame) const {
    Vector3d scale = Vector3d::Ones();
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const ScalarTrack* const track = of_joint_[joint][axis])
        scale(static_cast<Eigen::Index>(axis)) =
            static_cast<double>(track->values[static_cast<std::size_t>(frame)]);
    return scale;
  }

 private:
  std::vector<std::array<const ScalarTrack*, 3>> of_joint_;
  bool any_ = false;
};

/// All morph weights of a node.
struct WeightsTrack {
  std::size_t node = 0;  // its index in the file
  std::vector<const ScalarTrack*> of_target;
};

/// What is on its way into one buffer.
class BufferWriter {
 public:
  /// `bytes` are in the buffer already.
  BufferWriter(GltfJson& json, std::size_t buffer, std::string bytes)
      : json_(json), buffer_(buffer), bytes_(std::move(bytes)) {}

  /// The index of a new bufferView.
  std::size_t add_view(std::string_view bytes) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    GltfJson& views = array("bufferViews");
    views.push_back(
        {{"buffer", buffer_}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
    bytes_.append(bytes);
    return views.size() - 1;
  }

  /// The index of a new accessor: `components` x any number of floats.
  std::size_t add(const char* type, std::size_t components, const std::vector<float>& values,
                  bool with_range = false) {
    const std::size_t view =
        add_view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
    GltfJson accessor = {{"bufferView", view},
                         {"componentType", kFloat},
                         {"count", values.size() / components},
                         {"type", type}};
    if (with_range) {
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      accessor["min"] = GltfJson::array({*least});
      accessor["max"] = GltfJson::array({*most});
    }
    GltfJson& accessors = array("accessors");
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
  }

  std::string release() { return std::move(bytes_); }

 private:
  GltfJson& array(const char* key) {
    GltfJson& list = json_[key];
    if (!list.is_array()) list = GltfJson::array();
    return list;
  }

  GltfJson& json_;
  std::size_t buffer_;
  std::string bytes_;
};

/// Appends the samplers and channels of tracks to an animation.
class AnimationWriter {
 public:
  AnimationWriter(BufferWriter& buffer, GltfJson& animation, int frames, double sample_rate_hz)
      : buffer_(buffer), animation_(animation) {
    std::vector<float> times;
    for (int t = 0; t < frames; ++t) times.push_back(static_cast<float>(t / sample_rate_hz));
    times_ = buffer_.add("SCALAR", 1, times, true);
  }

  /// `always`: though it rests.
  void add(const NodeTrack& track, bool always) {
    constexpr double kSamePlace = 1e-8;  // m
    constexpr double kSameTurn = 1e-8;
    const auto moves = [&](const Vector3d& place) {
      return (place - track.rest.translation).norm() > kSamePlace;
    };
    const auto turns = [&](const Quaterniond& rotation) {
      return 1 - std::abs(rotation.dot(track.rest.rotation)) > kSameTurn * kSameTurn;
    };
    if (std::any_of(track.translation.begin(), track.translation.end(), moves))
      add_channel(track.node, "translation", times_,
                  buffer_.add("VEC3", 3, vectors(track.translation)));
    if (always || std::any_of(track.rotation.begin(), track.rotation.end(), turns))
      add_channel(track.node, "rotation", times_, buffer_.add("VEC4", 4, turnings(track)));
    if (!track.scales.empty())
      add_channel(track.node, "scale", times_, buffer_.add("VEC3", 3, vectors(track.scales)));
    if (track.scale) {
      if (!start_) start_ = buffer_.add("SCALAR", 1, {0.0F}, true);
      const Eigen::Vector3f scale = track.scale->cast<float>();
      add_channel(track.node, "scale", *start_,
                  buffer_.add("VEC3", 3, {scale.x(), scale.y(), scale.z()}));
    }
  }

  void add(const WeightsTrack& weights) {
    std::vector<float> values;
    for (std::size_t t = 0; t < weights.of_target.front()->values.size(); ++t)
      for (const ScalarTrack* const track : weights.of_target) values.push_back(track->values[t]);
    const bool steps = std::all_of(weights.of_target.begin(), weights.of_target.end(),
                                   [](const ScalarTrack* track) { return track->steps; });
    add_channel(weights.node, "weights", times_, buffer_.add("SCALAR", 1, values),
                steps ? "STEP" : "LINEAR");
  }

 private:
  static std::vector<float> vectors(const std::vector<Vector3d>& track) {
    std::vector<float> values;
    for (const Vector3d& vector : track)
      for (const double value : vector) values.push_back(static_cast<float>(value));
    return values;
  }

  /// Every quaternion on the side of the one before: from one to the next the way is short.
  static std::vector<float> turnings(const NodeTrack& track) {
    std::vector<float> values;
    Quaterniond last = track.rest.rotation;
    for (const Quaterniond& rotation : track.rotation) {
      const double side = rotation.dot(last) < 0 ? -1 : 1;
      last = Quaterniond(side * rotation.normalized().coeffs());
      for (const double value : last.coeffs()) values.push_back(static_cast<float>(value));
    }
    return values;
  }

  void add_channel(std::size_t node, const char* path, std::size_t input, std::size_t output,
                   const char* interpolation = "LINEAR") {
    GltfJson& samplers = animation_["samplers"];
    samplers.push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
    animation_["channels"].push_back(
        {{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  BufferWriter& buffer_;
  GltfJson& animation_;
  std::size_t times_;
  std::optional<std::size_t> start_;  // the one time 0
};

GltfJson json_of(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

GltfJson json_of(const Quaterniond& rotation) {
  return {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
}

/// What is not the default.
void set_transform(GltfJson& node, const LocalTransform& local) {
  if (!local.translation.isZero(0)) node["translation"] = json_of(local.translation);
  if (!local.rotation.coeffs().isApprox(Quaterniond::Identity().coeffs(), 1e-12))
    node["rotation"] = json_of(local.rotation);
  if (local.scale != Vector3d::Ones()) node["scale"] = json_of(local.scale);
}

/// The file in its container. `data` is the buffer number `buffer`. A .glb has it as its chunk.
std::string packed(GltfJson json, GltfContainer container, std::size_t buffer, std::string data,
                   const std::vector<GlbChunk>& others = {}) {
  json["buffers"][buffer]["byteLength"] = data.size();
  if (container == GltfContainer::Gltf) json["buffers"][buffer]["uri"] = kDataUri + base64_of(data);
  // What is no UTF-8 in a name becomes the sign for that.
  std::string text = json.dump(container == GltfContainer::Gltf ? 1 : -1, ' ', false,
                               GltfJson::error_handler_t::replace);
  if (container == GltfContainer::Gltf) return text + '\n';

  std::string file;
  const auto append_word = [&](std::size_t word) {
    const auto value = static_cast<std::uint32_t>(word);
    file.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto append_chunk = [&](std::uint32_t type, std::string bytes, char padding) {
    bytes.resize((bytes.size() + 3) / 4 * 4, padding);
    append_word(bytes.size());
    append_word(type);
    file += bytes;
  };
  for (const std::uint32_t word : {kGlbMagic, 2U, 0U}) append_word(word);
  append_chunk(kGlbJsonChunk, std::move(text), ' ');
  append_chunk(kGlbDataChunk, std::move(data), '\0');
  for (const GlbChunk& chunk : others) append_chunk(chunk.type, chunk.bytes, '\0');
  if (file.size() > std::numeric_limits<std::uint32_t>::max())
    throw WriteError("the motion is too large for a .glb: 4 GB are the most");
  const auto size = static_cast<std::uint32_t>(file.size());
  std::memcpy(file.data() + 8, &size, sizeof(size));
  return file;
}

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
GltfJson nodes_of(const Skeleton& skeleton, const std::vector<NodeTrack>& tracks,
                  double cm_per_unit) {
  const std::vector<std::string> names = gltf_names(skeleton);
  GltfJson nodes = GltfJson::array();
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

/// A source file's nodes as they are to move.
class SourceTracks {
 public:
  SourceTracks(const GltfFile& file, const GltfTake& take, const ReadOptions& options)
      : file_(file), take_(take.take), joint_of_node_(take_.nodes.size(), -1) {
    for (const std::size_t number : take.number_of_node) tracks_.push_back({.node = number});
    for (std::size_t n = 0; n < tracks_.size(); ++n) tracks_[n].rest = take_.nodes[n].rest;
    above_all_ = file_placement(options.cm_per_unit.value_or(take_.cm_per_unit),
                                options.up.value_or(take_.up));
  }

  /// The tracks of the nodes that are joints of `motion`, one for each.
  std::vector<NodeTrack> follow(const Motion& motion, const ReadOptions& options,
                                const JointScales& scales) {
    find_nodes(motion.skeleton, options);
    Pose pose;
    for (int t = 0; t < motion.clip.frames(); ++t) {
      compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
      place(pose, scales, t);
    }
    std::vector<NodeTrack> tracks;
    for (std::size_t n = 0; n < tracks_.size(); ++n) {
      if (joint_of_node_[n] < 0) continue;
      // Where a changing scale is not known, joints are in their places all the same.
      if (const Vector3d scale = still(n).scale;
          tracks_[n].scales.empty() && !scale.isApprox(tracks_[n].rest.scale, 1e-6))
        tracks_[n].scale = scale;
      tracks.push_back(std::move(tracks_[n]));
    }
    return tracks;
  }

 private:
  void find_nodes(const Skeleton& skeleton, const ReadOptions& options) {
    const std::vector<std::size_t> nodes = nodes_of_joints(file_.name(), take_);
    const Skeleton own =
        motion_of(file_.name(), take_, options, SourceFormat::Kind::Gltf).motion.skeleton;
    std::unordered_map<std::string, std::size_t> node_of_name;
    for (int j = 0; j < own.joint_count(); ++j)
      node_of_name.emplace(own.joint(j).name, nodes[static_cast<std::size_t>(j)]);
    const std::vector<std::string> names = without_namespace(gltf_names(skeleton));
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto found = node_of_name.find(names[j]);
      if (found == node_of_name.end())
        file_.fail("has no joint " + names[j] + ", which the motion has");
      joint_of_node_[found->second] = static_cast<int>(j);
    }
  }

  /// How a node that does not follow the motion stands, as the reader took it.
  const LocalTransform& still(std::size_t node) const {
    const AnimatedNode& of = take_.nodes[node];
    return of.frames.empty() ? of.rest : of.frames.front();
  }

  /// A node that follows has what is left between its place in the world and that of its parent.
  void place(const Pose& pose, const JointScales& scales, int frame) {
    placements_.resize(tracks_.size());
    for (std::size_t n = 0; n < tracks_.size(); ++n) {
      const int above = take_.nodes[n].parent;
      const NodePlacement& parent =
          above < 0 ? above_all_ : placements_[static_cast<std::size_t>(above)];
      LocalTransform local = still(n);
      if (joint_of_node_[n] >= 0) {
        const auto j = static_cast<std::size_t>(joint_of_node_[n]);
        local.translation = parent.world_from_node.inverse() * (pose.origin[j] - parent.origin);
        local.rotation = parent.rotation.conjugate() * Quaterniond(pose.world_from_joint[j]);
        if (!local.translation.allFinite())
          file_.fail("scales " + take_.nodes[n].name + " to nothing: it cannot follow a motion");
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

  const GltfFile& file_;
  const NodeTake& take_;
  std::vector<int> joint_of_node_;  // -1: it does not follow
  std::vector<NodeTrack> tracks_;   // of every node
  std::vector<NodePlacement> placements_;
  NodePlacement above_all_;
};

/// The weights of nodes of which tracks have all. Of tracks of one name, each is taken once.
std::vector<WeightsTrack> weights_of(const GltfTake& take, const ScalarTracks& tracks) {
  std::unordered_set<const ScalarTrack*> taken;
  std::map<std::size_t, WeightsTrack> of_node;
  for (std::size_t w = 0; w < take.weights.size(); ++w) {
    const ScalarTrack& wanted = take.take.tracks[w];
    const auto found = std::find_if(tracks.begin(), tracks.end(), [&](const ScalarTrack& track) {
      return track.kind == wanted.kind && track.node == wanted.node && track.name == wanted.name &&
             !taken.contains(&track);
    });
    WeightsTrack& weights = of_node[take.weights[w].node];
    weights.node = take.weights[w].node;
    weights.of_target.push_back(found == tracks.end() ? nullptr : &*found);
    if (found != tracks.end()) taken.insert(&*found);
  }
  std::vector<WeightsTrack> all;
  for (auto& [node, weights] : of_node)
    if (std::find(weights.of_target.begin(), weights.of_target.end(), nullptr) ==
        weights.of_target.end())
      all.push_back(std::move(weights));
  return all;
}

/// Leaves out what moves the nodes of `tracks`: channels, and the samplers that only these had.
void remove_channels(const GltfFile& file, const std::vector<NodeTrack>& tracks,
                     const std::vector<WeightsTrack>& weights, GltfJson& animation) {
  std::unordered_set<std::size_t> nodes;
  for (const NodeTrack& track : tracks) nodes.insert(track.node);
  std::unordered_set<std::size_t> morphed;
  for (const WeightsTrack& track : weights) morphed.insert(track.node);
  GltfJson channels = file.list(animation, "channels");
  GltfJson samplers = file.list(animation, "samplers");
  animation["channels"] = GltfJson::array();
  animation["samplers"] = GltfJson::array();
  std::unordered_map<std::size_t, std::size_t> new_index;
  for (GltfJson channel : channels) {
    const GltfJson& target = channel["target"];
    const auto node = file.index(target, "node", "nodes");
    const bool of_weights = file.text(target, "path") == "weights";
    if (node && (of_weights ? morphed : nodes).contains(*node)) continue;
    const std::size_t sampler = file.size(channel, "sampler", samplers.size());
    if (sampler >= samplers.size()) file.fail("has an animation channel without a sampler");
    const auto [at, is_new] = new_index.emplace(sampler, animation["samplers"].size());
    if (is_new) animation["samplers"].push_back(samplers[sampler]);
    channel["sampler"] = at->second;
    animation["channels"].push_back(std::move(channel));
  }
}

/// By its first bytes; empty for what is no image that a glTF may hold.
std::string image_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return "image/png";
  if (bytes.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  if (bytes.starts_with("\xABKTX 20")) return "image/ktx2";
  if (bytes.substr(0, 12).ends_with("WEBP")) return "image/webp";
  return "";
}

/// Joins all buffers into the first, for the chunk of a .glb, and returns its bytes.
std::string joined_buffers(GltfFile& file, GltfJson& json) {
  std::string bytes;
  std::vector<std::size_t> begins;
  for (std::size_t b = 0; b < file.list("buffers").size(); ++b) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    begins.push_back(bytes.size());
    bytes += file.buffer(b);
  }
  if (begins.empty()) return bytes;
  for (GltfJson& view : json["bufferViews"]) {
    const std::size_t buffer = file.required_index(view, "buffer", "buffers");
    if (buffer == 0) continue;
    view["byteOffset"] = file.size(view, "byteOffset", 0) + begins[buffer];
    view["buffer"] = 0;
  }
  GltfJson first = json["buffers"][0];
  first.erase("uri");
  json["buffers"] = GltfJson::array({std::move(first)});
  return bytes;
}

/// Puts the buffers that are files of their own, or the chunk of a .glb, into a .gltf.
void embed_buffers(GltfFile& file, GltfJson& json, bool with_files) {
  for (std::size_t b = 0; b < file.list("buffers").size(); ++b) {
    const std::string uri = file.text(file.list("buffers")[b], "uri");
    if (uri.empty() || (with_files && !is_data_uri(uri)))
      json["buffers"][b]["uri"] = kDataUri + base64_of(file.buffer(b));
  }
}

/// Puts images that are files of their own into the file. A .glb has them in its chunk, and those
/// of data URIs too. What is not there, or elsewhere, stays a reference.
void embed_images(const GltfFile& file, GltfJson& json, bool with_files, BufferWriter* chunk) {
  if (!json.contains("images")) return;
  GltfJson images = json["images"];  // apart: add_view() adds to `json`
  for (GltfJson& image : images) {
    const std::string uri = file.text(image, "uri");
    if (uri.empty() || (is_data_uri(uri) ? chunk == nullptr : !with_files)) continue;
    try {
      const std::string bytes = file.resource(uri);
      const std::string type = image_type(bytes);
      if (type.empty()) continue;
      if (chunk != nullptr) {
        image.erase("uri");
        image["mimeType"] = type;
        image["bufferView"] = chunk->add_view(bytes);
      } else {
        image["uri"] = "data:" + type + ";base64," + base64_of(bytes);
      }
    } catch (const InputError&) {
      continue;
    }
  }
  json["images"] = std::move(images);
}

bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a.empty() ? "." : a, b.empty() ? "." : b, error);
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
    const std::string valid =
        GltfJson::parse(
            GltfJson(joint.name).dump(-1, ' ', false, GltfJson::error_handler_t::replace))
            .get<std::string>();
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

  GltfJson nodes = nodes_of(skeleton, tracks, cm_per_unit);
  GltfJson joints = GltfJson::array();
  GltfJson roots = GltfJson::array();
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    joints.push_back(j);
    if (skeleton.joint(j).parent < 0) roots.push_back(j);
  }
  // The joints of a skin have a node above them all.
  if (roots.size() > 1) {
    nodes.push_back({{"name", "skeleton"}, {"children", roots}});
    roots = GltfJson::array({nodes.size() - 1});
  }
  GltfJson json = {{"asset", {{"version", "2.0"}, {"generator", "Mocapress"}}},
                   {"scene", 0},
                   {"scenes", GltfJson::array({{{"nodes", roots}}})},
                   {"nodes", nodes}};
  BufferWriter buffer(json, 0, "");
  const std::size_t matrices = buffer.add("MAT4", 16, inverse_bind_matrices(rest, cm_per_unit));
  json["skins"].push_back({{"inverseBindMatrices", matrices}, {"joints", joints}});
  GltfJson animation = {{"samplers", GltfJson::array()}, {"channels", GltfJson::array()}};
  AnimationWriter writer(buffer, animation, motion.clip.frames(), motion.clip.sample_rate_hz);
  for (const NodeTrack& track : tracks) writer.add(track, false);
  // Or else it would be no animation, and the number of frames be lost.
  if (animation["channels"].empty() && !tracks.empty()) writer.add(tracks.front(), true);
  json["animations"].push_back(std::move(animation));
  return packed(std::move(json), container, 0, buffer.release());
}

std::string gltf_bytes_onto(const fs::path& onto, const Motion& motion, GltfContainer container,
                            const fs::path& folder, const SourceFormat& source,
                            const WriteOptions& options, const ScalarTracks& scalars) {
  GltfFile file(onto, read_text(onto));
  const SourceFormat format = gltf_format(source, options);
  const ReadOptions reading{
      .cm_per_unit = format.cm_per_unit, .up = format.up, .take = options.take};
  const GltfTake take = read_gltf_take(file, reading);
  const std::vector<NodeTrack> tracks =
      SourceTracks(file, take, reading)
          .follow(motion, reading, JointScales(scalars, motion.skeleton));
  const std::vector<WeightsTrack> weights = weights_of(take, scalars);

  GltfJson json = file.json();
  for (const NodeTrack& track : tracks) {
    GltfJson& node = json["nodes"][track.node];
    // A node that an animation moves may have no matrix.
    if (node.erase("matrix") > 0) set_transform(node, track.rest);
  }
  // A .glb has one buffer, its chunk; a .gltf gets one more.
  const bool is_glb = container == GltfContainer::Glb;
  const bool moves_away = !same_folder(onto.parent_path(), folder);
  std::string data;
  if (is_glb)
    data = joined_buffers(file, json);
  else
    embed_buffers(file, json, moves_away);
  const std::size_t buffer = is_glb ? 0 : file.list("buffers").size();
  BufferWriter writer(json, buffer, std::move(data));
  embed_images(file, json, moves_away, is_glb ? &writer : nullptr);
  GltfJson animation = json["animations"][take.animation];
  remove_channels(file, tracks, weights, animation);
  AnimationWriter animator(writer, animation, motion.clip.frames(),
                           options.sample_rate_hz.value_or(motion.clip.sample_rate_hz));
  for (const NodeTrack& track : tracks) animator.add(track, false);
  for (const WeightsTrack& track : weights) animator.add(track);
  if (animation["channels"].empty() && !tracks.empty()) animator.add(tracks.front(), true);
  json["animations"][take.animation] = std::move(animation);
  std::vector<GlbChunk> others = file.chunks();
  if (!others.empty() && others.front().type == kGlbDataChunk) others.erase(others.begin());
  return packed(std::move(json), container, buffer, writer.release(), others);
}

}  // namespace mocapress
