// SPDX-License-Identifier: MIT
#include "core/motion/own_lengths.h"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <optional>

namespace mocapress {
namespace {

using Eigen::Vector3d;

constexpr double kSameLength = 0.2;    // cm
constexpr double kLeastDrop = 1;       // cm; shorter legs do not tell the size of a body
constexpr double kLargestScale = 100;  // and its inverse the smallest

/// A joint that carries some of the skin, and the bone that leads to it.
struct Carrier {
  int joint;                        // the clip's joint
  int above = -1;                   // index of the nearest carrier above; -1: none
  int below = 0;                    // number of bones with this one as `above`
  const SkinBone* bone;             // the skin's bone
  Vector3d in_bind;                 // cm, in the world of the bind pose
  Vector3d own;                     // cm, from `above`, in its frame
  std::optional<Vector3d> of_clip;  // likewise; none: `above` is not above it in the clip
};

/// The vector from a joint to another below it, with the joints between them at rest; unset if the
/// other is not below it.
std::optional<Vector3d> offset_between(const Skeleton& skeleton, int above, int joint) {
  Vector3d sum = Vector3d::Zero();
  for (; joint > above; joint = skeleton.joint(joint).parent) sum += skeleton.joint(joint).offset;
  return joint == above ? std::optional(sum) : std::nullopt;
}

/// Parents first.
std::vector<Carrier> carriers_of(const std::vector<SkinBone>& bones, const Skeleton& from,
                                 const Skeleton& to, const std::vector<int>& joint_in_to) {
  std::map<int, const SkinBone*> bone_of;  // the first of each joint
  for (const SkinBone& bone : bones) bone_of.emplace(bone.joint, &bone);
  std::map<int, int> place_of;
  std::vector<Carrier> carriers;
  for (const auto& [joint, bone] : bone_of) {
    Carrier carrier{.joint = joint_in_to[joint],
                    .bone = bone,
                    .in_bind = bone->joint_from_bind.inverse().translation(),
                    .own = Vector3d::Zero(),
                    .of_clip = {}};
    int above = from.joint(joint).parent;
    while (above >= 0 && !place_of.contains(above)) above = from.joint(above).parent;
    if (above >= 0) {
      carrier.above = place_of[above];
      Carrier& parent = carriers[carrier.above];
      ++parent.below;
      carrier.own = parent.bone->joint_from_bind * carrier.in_bind;
      carrier.of_clip = offset_between(to, parent.joint, carrier.joint);
    }
    place_of.emplace(joint, static_cast<int>(carriers.size()));
    carriers.push_back(carrier);
  }
  return carriers;
}

/// Marks the joints from the root to the hips, where the body first branches. Their places are the
/// clip's, scaled, since a clip may move any of them.
std::vector<bool> on_trunk(const std::vector<Carrier>& carriers) {
  std::vector<bool> trunk;
  for (const Carrier& carrier : carriers) trunk.push_back(carrier.above < 0);
  const auto hips =
      std::ranges::find_if(carriers, [](const Carrier& carrier) { return carrier.below > 1; });
  if (hips == carriers.end()) return trunk;
  for (auto at = static_cast<int>(hips - carriers.begin()); at >= 0; at = carriers[at].above)
    trunk[at] = true;
  return trunk;
}

/// The height of the hips above the lowest joint with the character's bones, divided by the same
/// height with the clip's bones. Both are taken in the pose in which the skin was bound, a standing
/// one.
double leg_scale(const std::vector<Carrier>& carriers, const std::vector<bool>& trunk) {
  std::size_t at = 0;  // a root, unless there is a limb
  for (std::size_t i = 0; i < carriers.size(); ++i)
    if (!trunk[i] && (trunk[at] || carriers[i].in_bind.y() < carriers[at].in_bind.y())) at = i;
  double own = 0;
  double of_clip = 0;
  while (!trunk[at]) {
    const auto above = static_cast<std::size_t>(carriers[at].above);
    if (!carriers[at].of_clip) return 1;
    own += carriers[above].in_bind.y() - carriers[at].in_bind.y();
    of_clip -=
        (carriers[above].bone->joint_from_bind.linear().inverse() * *carriers[at].of_clip).y();
    at = above;
  }
  const double scale = own / of_clip;
  const bool says = own > kLeastDrop && of_clip > kLeastDrop && scale < kLargestScale &&
                    scale > 1 / kLargestScale;
  return says ? scale : 1;
}

}  // namespace

OwnLengths own_lengths(const std::vector<SkinBone>& bones, const Skeleton& from, const Skeleton& to,
                       const std::vector<int>& joint_in_to) {
  const std::vector<Carrier> carriers = carriers_of(bones, from, to, joint_in_to);
  const std::vector<bool> trunk = on_trunk(carriers);
  OwnLengths lengths;
  lengths.scale = carriers.empty() ? 1 : leg_scale(carriers, trunk);
  bool differs = false;
  for (std::size_t i = 0; i < carriers.size(); ++i) {
    const Carrier& carrier = carriers[i];
    OwnLengths::Bone bone{carrier.joint, -1, Vector3d::Zero()};
    if (carrier.above >= 0) bone.above = carriers[carrier.above].joint;
    if (!trunk[i] && carrier.of_clip) {
      bone.longer = carrier.own - lengths.scale * *carrier.of_clip;
      differs = differs || (carrier.own - *carrier.of_clip).norm() > kSameLength;
    }
    lengths.bones.push_back(bone);
  }
  // Joints that carry no skin are moved by as much as the joints above them.
  for (int j = 0; j < to.joint_count(); ++j)
    if (to.joint(j).parent >= 0 &&
        std::ranges::none_of(carriers, [j](const Carrier& carrier) { return carrier.joint == j; }))
      lengths.bones.push_back({j, to.joint(j).parent, Vector3d::Zero()});
  return differs ? lengths : OwnLengths();
}

std::vector<Vector3d> own_origins(const OwnLengths& lengths, const Pose& pose) {
  if (lengths.bones.empty()) return pose.origin;
  std::vector<Vector3d> moved(pose.origin.size(), Vector3d::Zero());
  std::vector<Vector3d> origins;
  for (const auto& [joint, above, longer] : lengths.bones) {
    if (above < 0) continue;
    const auto a = static_cast<std::size_t>(above);
    moved[joint] = moved[a] + pose.world_from_joint[a] * longer;
  }
  for (std::size_t j = 0; j < moved.size(); ++j)
    origins.emplace_back(lengths.centre + lengths.scale * (pose.origin[j] - lengths.centre) +
                         moved[j]);
  return origins;
}

}  // namespace mocapress
