// SPDX-License-Identifier: MIT
#include "resources/samples/generator/human_skeleton.h"

#include <map>
#include <utility>
#include <vector>

namespace mocapress::samples {
namespace {

/// The frame along which the axes lie that a bone turns about.
enum class Axes { AsFrame, AsHand };

/// A bone as Acclaim has it: its children start at its end.
struct Bone {
  std::string name;
  std::string parent;
  Eigen::Vector3d end;  // shares of stature; the left one of a pair
  std::string dof;      // axes, the one turned about first in front
  Axes axes = Axes::AsFrame;
  bool last = false;  // ends its chain
};

const std::vector<Bone> kLeg = {
    {"hipjoint", "root", kHipInRoot / kStature, ""},
    {"femur", "hipjoint", {0, -0.245, 0}, "xyz"},
    {"tibia", "femur", {0, -0.246, 0}, "x"},
    {"foot", "tibia", kBallJointInFoot / kStature, "xz"},
    {"toes", "foot", {0, -0.006, 0.044}, "x", Axes::AsFrame, true},
};

const std::vector<Bone> kTrunk = {
    {"lowerback", "root", {0, 0.085, -0.004}, "xyz"},
    {"upperback", "lowerback", {0, 0.085, -0.004}, "xyz"},
    {"thorax", "upperback", {0, 0.085, 0.002}, "xyz"},
    {"lowerneck", "thorax", {0, 0.030, 0.006}, "xyz"},
    {"upperneck", "lowerneck", {0, 0.030, 0.004}, "xyz"},
    {"head", "upperneck", {0, 0.115, 0.002}, "xyz", Axes::AsFrame, true},
};

const std::vector<Bone> kArm = {
    {"clavicle", "thorax", {0.105, -0.009, 0}, "yz"},
    {"humerus", "clavicle", {0, -0.186, 0}, "xyz"},
    {"radius", "humerus", {0, -0.097, 0}, "x"},
    {"wrist", "radius", {0, -0.049, 0}, "y"},
    {"hand", "wrist", {0, -0.054, 0}, "xz", Axes::AsHand},
    {"fingers", "hand", {0, -0.054, 0}, "x", Axes::AsHand, true},
    {"thumb", "wrist", {0, -0.040, 0.032}, "xz", Axes::AsHand, true},
};

/// Fingers curl about the axis that points ahead when the arm hangs with the palm to the thigh.
Eigen::Matrix3d hand_from_axes(Side side) {
  const double sign = side == Side::Left ? 1 : -1;
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 0, 0, sign,  //
      0, 1, 0,                 //
      -sign, 0, 0;
  return quarter_turn;
}

class Builder {
 public:
  void add_root() {
    using enum ChannelKind;
    Joint root;
    root.name = "root";
    root.channels = {TranslationX, TranslationY, TranslationZ, RotationZ, RotationY, RotationX};
    add(std::move(root), Eigen::Vector3d::Zero());
  }

  void add_trunk() {
    for (const Bone& bone : kTrunk) add_bone(bone, bone.name, bone.parent, Side::Left);
  }

  void add_limb(const std::vector<Bone>& limb, Side side) {
    for (const Bone& bone : limb) {
      const bool attached = bone.parent == "root" || bone.parent == "thorax";
      add_bone(bone, sided(side, bone.name), attached ? bone.parent : sided(side, bone.parent),
               side);
    }
  }

  Skeleton take() { return std::move(skeleton_); }

 private:
  void add_bone(const Bone& bone, const std::string& name, const std::string& parent, Side side) {
    const Eigen::Vector3d end = mirrored_offset(side, bone.end * kStature);
    Joint joint;
    joint.name = name;
    joint.parent = skeleton_.find(parent);
    joint.offset = bone_ends_.at(parent);
    if (bone.axes == Axes::AsHand) joint.joint_from_axes = hand_from_axes(side);
    for (const char axis : bone.dof)
      joint.channels.insert(joint.channels.begin(), rotation_about(axis - 'x'));
    if (bone.last) joint.end_site = end;
    add(std::move(joint), end);
  }

  void add(Joint joint, const Eigen::Vector3d& bone_end) {
    bone_ends_[joint.name] = bone_end;
    skeleton_.add(std::move(joint));
  }

  Skeleton skeleton_;
  std::map<std::string, Eigen::Vector3d> bone_ends_;  // cm, in the bone's frame
};

}  // namespace

std::string sided(Side side, const std::string& bone) {
  return (side == Side::Left ? "l" : "r") + bone;
}

Eigen::Vector3d mirrored_offset(Side side, const Eigen::Vector3d& left) {
  return side == Side::Left ? left : Eigen::Vector3d(-left.x(), left.y(), left.z());
}

Eigen::Vector3d mirrored_angles(Side side, const Eigen::Vector3d& left) {
  return side == Side::Left ? left : Eigen::Vector3d(left.x(), -left.y(), -left.z());
}

Skeleton human_skeleton() {
  Builder builder;
  builder.add_root();
  builder.add_limb(kLeg, Side::Left);
  builder.add_limb(kLeg, Side::Right);
  builder.add_trunk();
  builder.add_limb(kArm, Side::Left);
  builder.add_limb(kArm, Side::Right);
  return builder.take();
}

}  // namespace mocapress::samples
