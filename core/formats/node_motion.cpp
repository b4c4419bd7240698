// SPDX-License-Identifier: MIT
#include "core/formats/node_motion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "core/formats/text_writer.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/rotation_form.h"
#include "core/motion/skin_points.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Smaller differences are rounding, since files hold floats.
constexpr double kSameShare = 1e-5;  // share of translations and scales; radians
constexpr double kSamePlace = 1e-3;  // cm
constexpr double kFarthest = 1e9;    // cm, or multiples of a scale
constexpr double kUnevenScale = 1e-4;

bool same_place(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm() <= kSameShare * (1 + a.norm());
}

bool same_turn(const Quaterniond& a, const Quaterniond& b) {
  return a.angularDistance(b) <= kSameShare;
}

bool same_transform(const LocalTransform& a, const LocalTransform& b) {
  return same_place(a.translation, b.translation) && same_place(a.scale, b.scale) &&
         same_turn(a.rotation, b.rotation);
}

bool moves(const LocalFrames& frames) {
  const auto changes = [](const auto& values, const auto& same) {
    return std::ranges::any_of(values,
                               [&](const auto& value) { return !same(values.front(), value); });
  };
  return changes(frames.translations(), same_place) || changes(frames.rotations(), same_turn) ||
         changes(frames.scales(), same_place);
}

bool is_possible(const Vector3d& vector) {
  return vector.allFinite() && vector.cwiseAbs().maxCoeff() <= kFarthest;
}

bool is_possible(const Quaterniond& rotation) {
  const double length = rotation.norm();
  return std::isfinite(length) && length > 1e-6;
}

bool is_possible(const LocalTransform& local) {
  return is_possible(local.translation) && is_possible(local.scale) && is_possible(local.rotation);
}

bool are_possible(const LocalFrames& frames) {
  const auto all = [](const auto& values) {
    return std::ranges::all_of(values, [](const auto& value) { return is_possible(value); });
  };
  return all(frames.translations()) && all(frames.rotations()) && all(frames.scales());
}

/// The use of a node for the skeleton.
enum class Role {
  None,    // left out
  Part,    // only moves the joints below it
  Joint,   //
  BoneEnd  // the end of its parent's bone
};

/// The nodes of a take and the role of each.
class NodeTree {
 public:
  NodeTree(const std::string& file, const std::vector<AnimatedNode>& nodes);

  Role role(std::size_t node) const { return roles_[node]; }
  LocalTransform local(std::size_t node, int frame) const;
  bool changes_scale(std::size_t node) const;
  /// The node that is the nearest joint above; -1: none.
  int joint_above(std::size_t node) const;

 private:
  void find_movement();
  void find_joints();
  void fold_from_top();
  void find_bone_ends();
  int joint_children(std::size_t node) const;

  const std::vector<AnimatedNode>& nodes_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<bool> moves_;
  std::vector<Role> roles_;
  bool are_marked_ = false;
};

NodeTree::NodeTree(const std::string& file, const std::vector<AnimatedNode>& nodes)
    : nodes_(nodes), children_(nodes.size()), roles_(nodes.size(), Role::None) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    assert(nodes[i].parent < static_cast<int>(i));
    if (nodes[i].parent >= 0) children_[nodes[i].parent].push_back(i);
    are_marked_ = are_marked_ || nodes[i].joint;
  }
  find_movement();
  find_joints();
  if (std::ranges::find(roles_, Role::Joint) == roles_.end())
    throw InputError(file, 0, 0, "has neither bones nor anything else that moves");
  fold_from_top();
  find_bone_ends();
}

void NodeTree::find_movement() {
  for (const AnimatedNode& node : nodes_) moves_.push_back(moves(node.frames));
}

/// Finds joints. Skeletons begin at marked nodes, or without marks at moving nodes. All nodes above
/// such a node are joints; of those below, the moving ones, or without marks all.
void NodeTree::find_joints() {
  const std::size_t count = nodes_.size();
  // above[i], below[i]: a node at which a skeleton begins is above node i, or below it.
  std::vector<bool> above(count);
  std::vector<bool> below(count);
  const auto begins = [&](std::size_t i) { return are_marked_ ? nodes_[i].joint : moves_[i]; };
  for (std::size_t i = 0; i < count; ++i)
    if (const int parent = nodes_[i].parent; parent >= 0) {
      const auto p = static_cast<std::size_t>(parent);
      above[i] = above[p] || begins(p);
    }
  for (std::size_t i = count; i-- > 0;)
    for (const std::size_t child : children_[i])
      below[i] = below[i] || below[child] || begins(child);
  for (std::size_t i = count; i-- > 0;) {
    const bool hangs = above[i] && (moves_[i] || !are_marked_);
    const bool carries =
        std::ranges::any_of(children_[i], [&](std::size_t c) { return roles_[c] == Role::Joint; });
    if (begins(i) || hangs || below[i] || carries) roles_[i] = Role::Joint;
  }
}

int NodeTree::joint_children(std::size_t node) const {
  return static_cast<int>(std::ranges::count_if(
      children_[node], [&](std::size_t child) { return roles_[child] == Role::Joint; }));
}

/// Turns motionless nodes at the top, such as armatures and scene roots, into parts of the world.
/// Without marks, stops where that would split a skeleton.
void NodeTree::fold_from_top() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (roles_[i] != Role::Joint) continue;
    const int parent = nodes_[i].parent;
    const bool on_top = parent < 0 || roles_[parent] == Role::Part;
    const int children = joint_children(i);
    const bool is_plain = same_transform(local(i, 0), {});
    const bool is_stand = on_top && !nodes_[i].joint && !moves_[i] && children > 0 &&
                          (are_marked_ || children == 1 || (is_plain && parent < 0));
    if (is_stand) roles_[i] = Role::Part;
  }
}

void NodeTree::find_bone_ends() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (roles_[i] != Role::Joint || children_[i].size() != 1) continue;
    const std::size_t child = children_[i].front();
    if (children_[child].empty() && roles_[child] == Role::None && !moves_[child])
      roles_[child] = Role::BoneEnd;
  }
}

LocalTransform NodeTree::local(std::size_t node, int frame) const {
  const AnimatedNode& of = nodes_[node];
  return of.frames.empty() ? of.rest : of.frames[frame];
}

bool NodeTree::changes_scale(std::size_t node) const {
  const auto& scales = nodes_[node].frames.scales();
  return std::ranges::any_of(scales, [&](const Vector3d& scale) {
    return (scale - scales.front()).norm() > kUnevenScale;
  });
}

int NodeTree::joint_above(std::size_t node) const {
  int above = nodes_[node].parent;
  while (above >= 0 && roles_[above] != Role::Joint) above = nodes_[above].parent;
  return above;
}

Eigen::Affine3d world_from(const NodePlacement& placement) {
  Eigen::Affine3d world_from_node = Eigen::Affine3d::Identity();
  world_from_node.linear() = placement.world_from_node;
  world_from_node.translation() = placement.origin;
  return world_from_node;
}

/// The movement of a joint relative to the joint above it.
struct Track {
  std::vector<Vector3d> translation;  // cm
  std::vector<Quaterniond> rotation;
};

/// The order whose middle angle stays farthest from a right angle. The sine of that angle is one
/// element of the matrix.
RotationOrder calmest_order(const Track& track) {
  Matrix3d largest = Matrix3d::Zero();
  for (const Quaterniond& rotation : track.rotation)
    largest = largest.cwiseMax(rotation.toRotationMatrix().cwiseAbs());
  RotationOrder calmest = RotationOrder::Xyz;
  const auto sine = [&](RotationOrder order) {
    const std::array<int, 3> axes = axes_of(order);
    return largest(axes[0], axes[2]);
  };
  for (int o = 1; o < kRotationOrders; ++o)
    if (const auto order = static_cast<RotationOrder>(o); sine(order) < sine(calmest))
      calmest = order;
  return calmest;
}

/// Builds the motion of a take, joint by joint.
class MotionBuilder {
 public:
  MotionBuilder(const std::string& file, const NodeTake& take, const ReadOptions& options,
                SourceFormat::Kind kind)
      : file_(file), take_(take), tree_(file, take.nodes) {
    source_.kind = kind;
    source_.cm_per_unit = options.cm_per_unit.value_or(take.cm_per_unit);
    source_.up = options.up.value_or(take.up);
  }

  MotionFile build();
  Character build_character();
  std::vector<std::size_t> nodes_of_joints() {
    number_joints();
    return std::move(node_of_joint_);
  }

 private:
  void build_skeleton();
  void hold_still();
  void check();
  void number_joints();
  NodePlacement placed(std::size_t node, const LocalTransform& local,
                       const std::vector<NodePlacement>& placements) const;
  void place_nodes();
  void place_frame(int frame, std::vector<NodePlacement>& placements);
  void add_skin();
  void name_joints();
  void add_joint(std::size_t joint);
  void add_scales();
  void warn_of_scale();
  void warn(std::string message) { warnings_.push_back({file_, 0, std::move(message)}); }

  const std::string& file_;
  const NodeTake& take_;
  NodeTree tree_;
  SourceFormat source_;
  Warnings warnings_;
  std::vector<Joint> joints_;
  std::vector<std::size_t> node_of_joint_;
  std::vector<int> joint_of_node_;  // -1: none
  std::vector<Track> tracks_;       // one for each joint
  ScalarTracks tracks_of_clip_;
  std::vector<NodePlacement> first_placements_;
  std::shared_ptr<const Skin> skin_;
  Skeleton skeleton_;
  std::vector<Eigen::VectorXd> channels_;
};

void MotionBuilder::build_skeleton() {
  number_joints();
  check();
  place_nodes();
  name_joints();
  for (std::size_t j = 0; j < joints_.size(); ++j) add_joint(j);
}

/// Gives a clip that has tracks but no moving joint three constant channels, on its first joint.
void MotionBuilder::hold_still() {
  if (take_.tracks.empty()) throw InputError(file_, 0, 0, "no joint moves or is turned");
  for (int axis = 0; axis < 3; ++axis) {
    joints_.front().channels.push_back(rotation_about(axis));
    channels_.push_back(Eigen::VectorXd::Zero(take_.frames));
  }
  skeleton_ = {};
  for (const Joint& joint : joints_) skeleton_.add(joint);
}

Character MotionBuilder::build_character() {
  build_skeleton();
  add_skin();
  if (skin_) return {std::move(skeleton_), std::move(skin_)};
  throw InputError(
      file_, 0, 0,
      warnings_.empty() ? "has no mesh that hangs on joints" : warnings_.back().message);
}

MotionFile MotionBuilder::build() {
  build_skeleton();
  if (channels_.empty()) hold_still();
  warn_of_scale();
  add_scales();
  add_skin();
  measure_on(skin_.get(), skeleton_);
  Motion motion{std::move(skeleton_), {take_.sample_rate_hz, {}}};
  motion.clip.channels.resize(take_.frames, static_cast<Eigen::Index>(channels_.size()));
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    motion.clip.channels.col(c) = channels_[c];
    channels_[c] = {};  // a long clip is not held twice
  }
  return {.motion = std::move(motion),
          .warnings = std::move(warnings_),
          .source = source_,
          .skin = std::move(skin_),
          .tracks = std::move(tracks_of_clip_)};
}

void MotionBuilder::number_joints() {
  joint_of_node_.assign(take_.nodes.size(), -1);
  for (std::size_t i = 0; i < take_.nodes.size(); ++i) {
    if (tree_.role(i) != Role::Joint) continue;
    joint_of_node_[i] = static_cast<int>(joints_.size());
    const int above = tree_.joint_above(i);
    node_of_joint_.push_back(i);
    joints_.push_back(
        {.name = take_.nodes[i].name, .parent = above < 0 ? -1 : joint_of_node_[above]});
  }
}

void MotionBuilder::check() {
  const auto refuse = [&](const std::string& what) { throw InputError(file_, 0, 0, what); };
  if (joints_.size() > runtime::kMostJoints)
    refuse("more than " + std::to_string(runtime::kMostJoints) + " joints");
  std::vector<int> depths;
  for (const Joint& joint : joints_) {
    depths.push_back(joint.parent < 0 ? 1 : depths[joint.parent] + 1);
    if (depths.back() > runtime::kMostDepth)
      refuse("joints are nested deeper than " + std::to_string(runtime::kMostDepth));
  }
  check_take_size(file_, joints_.size(), take_.frames);
  for (const AnimatedNode& node : take_.nodes) {
    assert(node.frames.empty() || node.frames.size() == static_cast<std::size_t>(take_.frames));
    if (!is_possible(node.rest) || !are_possible(node.frames))
      refuse(shortened(node.name) + " has a transform that is not finite, or beyond 1e9");
  }
}

void MotionBuilder::place_nodes() {
  const auto frames = static_cast<std::size_t>(take_.frames);
  tracks_.assign(joints_.size(), {std::vector<Vector3d>(frames), std::vector<Quaterniond>(frames)});
  std::vector<NodePlacement> placements(take_.nodes.size());
  for (int t = 0; t < take_.frames; ++t) {
    place_frame(t, placements);
    if (t == 0) first_placements_ = placements;
  }
}

/// The placement in the world of a node whose transform relative to its parent is `local`.
NodePlacement MotionBuilder::placed(std::size_t node, const LocalTransform& local,
                                    const std::vector<NodePlacement>& placements) const {
  const int parent = take_.nodes[node].parent;
  return below(parent < 0 ? file_placement(source_.cm_per_unit, source_.up) : placements[parent],
               local);
}

void MotionBuilder::place_frame(int frame, std::vector<NodePlacement>& placements) {
  const NodePlacement world = file_placement(1, UpAxis::Y);
  for (std::size_t i = 0; i < take_.nodes.size(); ++i) {
    const Role role = tree_.role(i);
    placements[i] = placed(i, tree_.local(i, frame), placements);
    if (role == Role::None || role == Role::Part) continue;
    const int above = tree_.joint_above(i);
    const NodePlacement& from = above < 0 ? world : placements[above];
    const Vector3d in_parent = from.rotation.conjugate() * (placements[i].origin - from.origin);
    if (!in_parent.allFinite() || in_parent.norm() > kFarthest)
      throw InputError(file_, 0, 0,
                       shortened(take_.nodes[i].name) + " is farther than 1e9 cm away");
    if (role == Role::BoneEnd) {
      Joint& joint = joints_[joint_of_node_[above]];
      if (frame == 0 && in_parent.norm() > kSamePlace) joint.end_site = in_parent;
      continue;
    }
    Track& track = tracks_[joint_of_node_[i]];
    track.translation[frame] = in_parent;
    track.rotation[frame] = (from.rotation.conjugate() * placements[i].rotation).normalized();
  }
}

void MotionBuilder::name_joints() {
  std::vector<std::string> names;
  for (const Joint& joint : joints_) names.push_back(joint.name);
  names = without_namespace(std::move(names));
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].name = names[j];
  std::unordered_set<std::string> taken;
  for (const Joint& joint : joints_) taken.insert(joint.name);
  std::unordered_set<std::string> seen;
  std::unordered_map<std::string, int> last_number;  // last number given to each repeated name
  int renamed = 0;
  for (Joint& joint : joints_) {
    if (joint.name.size() > runtime::kMostNameBytes)
      throw InputError(file_, 0, 0,
                       "the name of a joint has more than " +
                           std::to_string(runtime::kMostNameBytes) + " bytes");
    if (joint.name.empty()) joint.name = "joint";
    if (seen.insert(joint.name).second) continue;
    const std::string name = joint.name;
    int& n = last_number.try_emplace(name, 1).first->second;
    while (!taken.insert(joint.name).second) joint.name = name + '.' + std::to_string(++n);
    seen.insert(joint.name);
    ++renamed;
  }
  if (renamed > 0)
    warn(counted(renamed, "joint") + " with the name of another joint, numbered: Name.2");
}

void MotionBuilder::add_joint(std::size_t j) {
  Joint& joint = joints_[j];
  const Track track = std::move(tracks_[j]);
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& place : track.translation) mean += place / take_.frames;
  joint.offset = mean;
  if (std::ranges::any_of(track.translation, [&](const Vector3d& place) {
        return (place - mean).norm() > kSamePlace;
      })) {
    joint.offset = track.translation.front();
    for (int axis = 0; axis < 3; ++axis) {
      joint.channels.push_back(translation_about(axis));
      Eigen::VectorXd channel(take_.frames);
      for (int t = 0; t < take_.frames; ++t)
        channel(t) = track.translation[t](axis) - joint.offset(axis);
      channels_.push_back(std::move(channel));
    }
  }
  if (std::ranges::any_of(track.rotation, [](const Quaterniond& rotation) {
        return rotation.angularDistance(Quaterniond::Identity()) > kSameShare;
      })) {
    const std::array<int, 3> axes = axes_of(calmest_order(track));
    const std::size_t first = channels_.size();
    for (const int axis : axes) {
      joint.channels.push_back(rotation_about(axis));
      channels_.emplace_back(take_.frames);
    }
    Vector3d last = Vector3d::Zero();
    for (int t = 0; t < take_.frames; ++t) {
      last = three_angles(axes, track.rotation[t].toRotationMatrix(), last);
      for (int i = 0; i < 3; ++i) channels_[first + static_cast<std::size_t>(i)](t) = last(i);
    }
  }
  skeleton_.add(joint);
}

void MotionBuilder::add_skin() {
  if (take_.meshes.empty()) return;
  std::vector<NodeJoint> nodes(take_.nodes.size());
  std::vector<NodePlacement> rest(take_.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    rest[i] = placed(i, take_.nodes[i].rest, rest);
    nodes[i].rest_world_from_node = world_from(rest[i]);
    const int carrier = tree_.role(i) == Role::Joint ? static_cast<int>(i) : tree_.joint_above(i);
    if (carrier < 0) continue;
    const NodePlacement& joint = first_placements_[carrier];
    Eigen::Affine3d world_from_joint = Eigen::Affine3d::Identity();
    world_from_joint.linear() = joint.rotation.toRotationMatrix();
    world_from_joint.translation() = joint.origin;
    nodes[i].joint = joint_of_node_[carrier];
    nodes[i].joint_from_node = world_from_joint.inverse() * world_from(first_placements_[i]);
  }
  skin_ = skin_of(file_, take_.meshes, nodes,
                  world_from(file_placement(source_.cm_per_unit, source_.up)), warnings_);
}

/// Adds tracks for joints' scales that change over time.
void MotionBuilder::add_scales() {
  tracks_of_clip_ = take_.tracks;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const std::size_t node = node_of_joint_[j];
    if (!tree_.changes_scale(node)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      ScalarTrack track{
          .kind = scale_along(axis), .node = joints_[j].name, .name = {}, .values = {}};
      for (int t = 0; t < take_.frames; ++t)
        track.values.push_back(static_cast<float>(tree_.local(node, t).scale(axis)));
      tracks_of_clip_.push_back(std::move(track));
    }
  }
}

void MotionBuilder::warn_of_scale() {
  int changing = 0;
  int uneven = 0;
  std::string first_uneven;
  for (std::size_t i = 0; i < take_.nodes.size(); ++i) {
    if (tree_.role(i) != Role::Joint && tree_.role(i) != Role::Part) continue;
    changing += tree_.changes_scale(i);
    const Vector3d size = tree_.local(i, 0).scale.cwiseAbs();
    if (size.maxCoeff() - size.minCoeff() <= kUnevenScale * size.maxCoeff()) continue;
    if (++uneven == 1) first_uneven = take_.nodes[i].name;
  }
  if (changing > 0)
    warn(counted(changing, "node") +
         " whose scale changes over time: joints are in their places, those of joints are kept as "
         "tracks, but errors are measured on a skin with the scales of the first frame");
  if (uneven > 0)
    warn(counted(uneven, "node") + " scaled unevenly, first " + shortened(first_uneven) +
         ": joints are in their places, but a skin has the scales of the first frame");
}

}  // namespace

NodePlacement file_placement(double cm_per_unit, UpAxis up) {
  const Quaterniond y_up_from_file = up == UpAxis::Z
                                         ? Quaterniond(std::sqrt(0.5), -std::sqrt(0.5), 0, 0)
                                         : Quaterniond::Identity();
  const Matrix3d world_from_file = cm_per_unit * y_up_from_file.toRotationMatrix();
  return {.world_from_node = world_from_file,
          .origin = Vector3d::Zero(),
          .rotation = y_up_from_file,
          .without_scale = world_from_file,
          .scale = Vector3d::Ones()};
}

NodePlacement below(const NodePlacement& parent, const LocalTransform& local) {
  const Quaterniond turn = local.rotation.normalized();
  const bool is_whole = local.inherit == ScaleOfParent::Whole;
  NodePlacement placement;
  placement.origin = parent.origin + parent.world_from_node * local.translation;
  placement.rotation = parent.rotation * turn;
  placement.without_scale =
      (is_whole ? parent.world_from_node : parent.without_scale) * turn.toRotationMatrix();
  placement.scale = local.scale;
  if (local.inherit == ScaleOfParent::ByAxis)
    placement.scale = parent.scale.cwiseProduct(local.scale);
  placement.world_from_node = placement.without_scale * placement.scale.asDiagonal();
  return placement;
}

void check_take_size(const std::string& file, std::size_t moving_nodes, double frames) {
  constexpr double kMostChannels = 6;  // channels of a node, at most
  constexpr std::uint64_t kBytesOfMovingNode =
      sizeof(LocalTransform) + sizeof(Vector3d) + sizeof(Quaterniond) + 2 * 6 * sizeof(double);
  if (!(frames >= 1 && frames <= runtime::kMostFrames))
    throw InputError(file, 0, 0,
                     "needs more than " + std::to_string(runtime::kMostFrames) + " frames");
  if (frames * static_cast<double>(moving_nodes) * kMostChannels > runtime::kMostValues)
    throw InputError(file, 0, 0,
                     "needs more than " + std::to_string(runtime::kMostValues) + " samples");
  // Memory for a moving node's transform, track and channels.
  require_memory(file, static_cast<std::uint64_t>(frames) * moving_nodes * kBytesOfMovingNode);
}

MotionFile motion_of(const std::string& file, const NodeTake& take, const ReadOptions& options,
                     SourceFormat::Kind kind) {
  return MotionBuilder(file, take, options, kind).build();
}

Character character_of(const std::string& file, const NodeTake& take) {
  return MotionBuilder(file, take, {}, SourceFormat::Kind::None).build_character();
}

std::vector<std::size_t> nodes_of_joints(const std::string& file, const NodeTake& take) {
  return MotionBuilder(file, take, {}, SourceFormat::Kind::None).nodes_of_joints();
}

std::vector<std::string> without_namespace(std::vector<std::string> names) {
  if (names.empty() || names.front().find(':') == std::string::npos) return names;
  const std::string shared = names.front().substr(0, names.front().rfind(':') + 1);
  const bool of_all = std::ranges::all_of(names, [&](const std::string& name) {
    return name.starts_with(shared) && name.size() > shared.size();
  });
  if (of_all)
    for (std::string& name : names) name.erase(0, shared.size());
  return names;
}

}  // namespace mocapress
