// SPDX-License-Identifier: MIT
#include "core/motion/skin.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/motion/own_lengths.h"
#include "core/motion/rig.h"
#include "core/motion/skin_points.h"

namespace mocapress {
namespace {

using Eigen::Affine3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSameDirection = 0.97;  // cosine
constexpr double kSameAxes = 0.8;        // least share of bone length whose directions agree
constexpr double kShortest = 0.1;        // cm; shorter bones have no direction
constexpr double kLeastCarried = 0.5;    // least share of the surface on joints of the clip

/// Maps joints of one skeleton to joints of another with the same name; -1: none.
std::vector<int> joints_by_name(const Skeleton& from, const Skeleton& to) {
  std::unordered_map<std::string, int> found;
  for (int j = 0; j < to.joint_count(); ++j) found.emplace(without_namespace(to.joint(j).name), j);
  std::vector<int> joints;
  for (const Joint& joint : from.joints()) {
    const auto same = found.find(without_namespace(joint.name));
    joints.push_back(same == found.end() ? -1 : same->second);
  }
  return joints;
}

/// Throws Error if joints that `to` lacks carry most of the skin.
void require_most(const Skin& skin, const Skeleton& from, const Skeleton& to,
                  const std::vector<int>& joint_in_to) {
  const auto is_there = [&](int joint) { return joint_in_to[joint] >= 0; };
  double carried = 0;
  const SkinPoints points = points_on(skin);
  for (const SkinPoint& point : points)
    for (const SkinPointShare& share : point) carried += is_there(share.joint) ? share.weight : 0;
  const bool any =
      std::ranges::any_of(skin.bones, [&](const SkinBone& bone) { return is_there(bone.joint); });
  if (any && carried >= kLeastCarried * static_cast<double>(points.size())) return;
  const std::vector<std::string> missing = missing_joints(skin, from, to);
  if (missing.empty()) return;
  throw Error("the clip has no joint " + shortened(missing.front()) +
              (missing.size() > 1 ? ", nor " + std::to_string(missing.size() - 1) + " more" : "") +
              ": they carry most of the character");
}

/// Binds the vertices of joints that `to` lacks to the nearest joint above that it has, keeping
/// their places in the bind pose.
void hold_missing(Skin& skin, const Skeleton& from, const std::vector<int>& joint_in_to) {
  const std::vector<SkinBone> bones = skin.bones;
  const auto bone_of = [&](int joint) {
    return std::ranges::find_if(bones, [&](const SkinBone& bone) { return bone.joint == joint; });
  };
  const auto topmost = std::ranges::find_if(
      bones, [&](const SkinBone& bone) { return joint_in_to[bone.joint] >= 0; });
  for (SkinBone& bone : skin.bones) {
    // Passes over joints that carry nothing, since their places in the bind pose are unknown.
    int carrier = bone.joint;
    while (carrier >= 0 && (joint_in_to[carrier] < 0 || bone_of(carrier) == bones.end()))
      carrier = from.joint(carrier).parent;
    if (carrier != bone.joint) bone = carrier < 0 ? *topmost : *bone_of(carrier);
  }
}

/// True if joints have the same axes in both skeletons, that is, their children lie in the same
/// directions.
bool have_same_axes(const Skeleton& from, const Skeleton& to, const std::vector<int>& joint_in_to) {
  double same = 0;
  double all = 0;
  for (std::size_t j = 0; j < joint_in_to.size(); ++j) {
    const Joint& ours = from.joints()[j];
    if (joint_in_to[j] < 0 || ours.parent < 0) continue;
    const Joint& theirs = to.joint(joint_in_to[j]);
    if (theirs.parent < 0 || theirs.parent != joint_in_to[ours.parent]) continue;
    const double length = ours.offset.norm();
    if (length < kShortest || theirs.offset.norm() < kShortest) continue;
    all += length;
    if (ours.offset.normalized().dot(theirs.offset.normalized()) > kSameDirection) same += length;
  }
  return same >= kSameAxes * all;
}

/// The rotation of the mesh around each joint of `from`, from the bind pose to the rest pose of
/// `to`, in which the joint's bone may point elsewhere. A joint without exactly one bone turns as
/// its parent does.
std::vector<Matrix3d> rest_from_bind(const Skin& skin, const Skeleton& from, const Skeleton& to,
                                     const std::vector<int>& joint_in_to) {
  const auto count = static_cast<std::size_t>(from.joint_count());
  std::vector<std::optional<Vector3d>> in_bind(count);
  for (const SkinBone& bone : skin.bones)
    in_bind[bone.joint] = bone.joint_from_bind.inverse().translation();
  const Pose rest = rest_pose(to);
  std::vector<int> children(count);
  std::vector<Matrix3d> swings(count, Matrix3d::Identity());
  for (std::size_t child = 0; child < count; ++child) {
    if (from.joints()[child].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(from.joints()[child].parent);
    if (!in_bind[child] || !in_bind[parent] || joint_in_to[child] < 0 || joint_in_to[parent] < 0)
      continue;
    const Vector3d ours = *in_bind[child] - *in_bind[parent];
    const Vector3d theirs = rest.origin[joint_in_to[child]] - rest.origin[joint_in_to[parent]];
    if (ours.norm() < kShortest || theirs.norm() < kShortest) continue;
    swings[parent] = shortest_turn(ours, theirs);
    ++children[parent];
  }
  std::vector<Matrix3d> turns;
  for (std::size_t j = 0; j < count; ++j) {
    const int parent = from.joints()[j].parent;
    const Matrix3d inherited = parent < 0 ? Matrix3d::Identity() : turns[parent];
    turns.push_back(children[j] == 1 ? swings[j] : inherited);
  }
  return turns;
}

}  // namespace

BoneWeights largest_weights(std::vector<std::pair<std::uint8_t, double>> weights) {
  BoneWeights result;
  std::erase_if(weights, [](const auto& each) { return !(each.second > 0); });
  std::ranges::stable_sort(weights,
                           [](const auto& a, const auto& b) { return a.second > b.second; });
  if (weights.size() > result.weights.size()) weights.resize(result.weights.size());
  double sum = 0;
  for (const auto& [bone, weight] : weights) sum += weight;
  if (weights.empty()) result.weights[0] = 1;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    result.bones[i] = weights[i].first;
    result.weights[i] = static_cast<float>(weights[i].second / sum);
  }
  return result;
}

std::vector<Affine3d> world_from_bind(const Skin& skin, const Pose& pose) {
  const std::vector<Vector3d> origins = own_origins(skin.lengths, pose);
  std::vector<Affine3d> transforms;
  for (const SkinBone& bone : skin.bones) {
    const auto joint = static_cast<std::size_t>(bone.joint);
    Affine3d world_from_joint = Affine3d::Identity();
    world_from_joint.linear() = pose.world_from_joint[joint];
    world_from_joint.translation() = origins[joint];
    transforms.push_back(world_from_joint * bone.joint_from_bind);
  }
  return transforms;
}

std::vector<Vector3d> skinned_positions(const Skin& skin, const Pose& pose) {
  const std::vector<Affine3d> bones = world_from_bind(skin, pose);
  std::vector<Vector3d> positions;
  positions.reserve(skin.vertices.size());
  for (const Skin::Vertex& vertex : skin.vertices) {
    const Vector3d in_bind = vertex.in_bind.cast<double>();
    Vector3d in_world = Vector3d::Zero();
    for (std::size_t i = 0; i < vertex.carried_by.weights.size(); ++i)
      if (const auto weight = static_cast<double>(vertex.carried_by.weights[i]); weight > 0)
        in_world += weight * (bones[vertex.carried_by.bones[i]] * in_bind);
    positions.push_back(in_world);
  }
  return positions;
}

std::vector<std::string> missing_joints(const Skin& skin, const Skeleton& from,
                                        const Skeleton& to) {
  const std::vector<int> joint_in_to = joints_by_name(from, to);
  std::vector<std::string> missing;
  for (const SkinBone& bone : skin.bones) {
    const std::string& name = from.joint(bone.joint).name;
    if (joint_in_to[bone.joint] < 0 && std::ranges::find(missing, name) == missing.end())
      missing.push_back(name);
  }
  return missing;
}

Skin bound_to(const Skin& skin, const Skeleton& from, const Skeleton& to) {
  const std::vector<int> joint_in_to = joints_by_name(from, to);
  require_most(skin, from, to, joint_in_to);
  Skin bound = skin;
  hold_missing(bound, from, joint_in_to);
  if (!have_same_axes(from, to, joint_in_to)) {
    const std::vector<Matrix3d> turns = rest_from_bind(bound, from, to, joint_in_to);
    for (SkinBone& bone : bound.bones) {
      // In the rest pose, the frames of `to` are parallel to the world's.
      const Matrix3d& turn = turns[bone.joint];
      Affine3d from_bind = Affine3d::Identity();
      from_bind.linear() = turn;
      from_bind.translation() = -turn * bone.joint_from_bind.inverse().translation();
      bone.joint_from_bind = from_bind;
    }
  }
  bound.lengths = own_lengths(bound.bones, from, to, joint_in_to);
  for (SkinBone& bone : bound.bones) bone.joint = joint_in_to[bone.joint];
  return bound;
}

}  // namespace mocapress
