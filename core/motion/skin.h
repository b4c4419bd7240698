// SPDX-License-Identifier: MIT
// The look of a character: a mesh that its joints carry, by linear blend skinning as in engines.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/forward_kinematics.h"

namespace mocapress {

/// A joint that carries vertices. The matrix includes scales, which joints lack.
struct SkinBone {
  int joint = 0;
  Eigen::Affine3d joint_from_bind = Eigen::Affine3d::Identity();
};

/// The four bones with the most weight at a vertex. Weights sum to 1; unused ones are 0.
struct BoneWeights {
  std::array<std::uint8_t, 4> bones{};
  std::array<float, 4> weights{};
};

/// A character's own bone lengths, on a clip of a body with other lengths. Joints turn as in the
/// clip. A joint's place is that in the clip, scaled by `scale` about `centre`, plus the
/// differences in length of the bones above the joint. So the mesh does not tear, and feet reach
/// the floor, y = 0.
struct OwnLengths {
  struct Bone {
    int joint;               // the clip's joint at the end of the bone
    int above;               // the joint at which the bone begins; -1: none
    Eigen::Vector3d longer;  // cm, in the frame of `above`
  };
  double scale = 1;  // leg length of the character / of the clip's body; scales the world
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // cm, on the floor: the world grows around it
  std::vector<Bone> bones;                           // parents first; empty: the clip's lengths
};

/// A picture with a mesh's colours: a PNG or JPEG as it is in the file.
struct SkinPicture {
  std::string name;
  std::string bytes;
};

/// A triangle mesh in its bind pose: the pose in which it was bound to a skeleton's joints.
struct Skin {
  // The limit on bones: indices are bytes, and every graphics driver gives a shader room for this
  // many.
  static constexpr std::size_t kMostBones = 256;

  struct Vertex {
    Eigen::Vector3f in_bind;  // cm, y up, world space of the bind pose
    Eigen::Vector3f normal;   // unit vector in the same space
    Eigen::Vector3f colour;   // red, green, blue of a screen (sRGB), 0 ... 1
    BoneWeights carried_by;
    // Place in the picture: measured from the upper left corner, in widths and heights; it repeats.
    Eigen::Vector2f in_picture = Eigen::Vector2f::Zero();
    int picture = -1;  // index into `pictures`; `colour` multiplies it; -1: `colour` alone
  };

  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<SkinBone> bones;
  std::vector<std::shared_ptr<const SkinPicture>> pictures;
  OwnLengths lengths;

  bool empty() const { return triangles.empty(); }
};

/// A skin and the skeleton whose joints carry it.
struct Character {
  Skeleton skeleton;
  std::shared_ptr<const Skin> skin;  // null: no character
};

/// The colour of a material that has none of its own.
inline const Eigen::Vector3f kPlainSkin{0.72F, 0.69F, 0.66F};

/// The four largest weights, made to sum to 1. Without any weight, all of it goes to bone 0.
BoneWeights largest_weights(std::vector<std::pair<std::uint8_t, double>> weights);

/// The transform of each bone's mesh from the bind pose to a pose.
std::vector<Eigen::Affine3d> world_from_bind(const Skin& skin, const Pose& pose);

/// Positions (cm) of the vertices in a pose.
std::vector<Eigen::Vector3d> skinned_positions(const Skin& skin, const Pose& pose);

/// Moves the skin to a skeleton that has joints of the same names, ignoring prefixes that end with
/// a colon. The joints may have other axes, if the rest pose of `to` is about the pose in which the
/// skin was bound (as a BVH's is). Vertices on joints that `to` lacks follow the nearest ancestor
/// that it has, as they were bound. Bones keep their own lengths if these differ. Throws Error that
/// names the missing joints if they carry most of the skin.
Skin bound_to(const Skin& skin, const Skeleton& from, const Skeleton& to);

/// Names of the joints in `from` that carry some of the skin and that `to` lacks.
std::vector<std::string> missing_joints(const Skin& skin, const Skeleton& from, const Skeleton& to);

}  // namespace mocapress
