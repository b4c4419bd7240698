// SPDX-License-Identifier: MIT
// The step that FBX and glTF share: from a tree of nodes that move, turn and scale to a skeleton of
// joints that turn, and of which few move.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"
#include "core/formats/node_skin.h"

namespace mocapress {

/// What a node takes over of its parent's scale. Its translation is scaled in any case.
enum class ScaleOfParent : std::uint8_t {
  Whole,   // as glTF, and FBX where it says RSrs: a turned node is sheared
  ByAxis,  // RrSs: scales are multiplied axis by axis, below all turns
  None     // Rrs: Maya's segment scale compensation
};

/// x_in_parent = translation + rotation * scale * x_in_node, in the file's unit, where the parent's
/// scale applies as a whole.
struct LocalTransform {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // of any length but 0
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  ScaleOfParent inherit = ScaleOfParent::Whole;
};

struct AnimatedNode {
  std::string name;
  int parent = -1;     // comes before its children; -1: hangs from nothing
  bool joint = false;  // the file says that it is a bone of a skin; else it may be anything
  LocalTransform rest;
  std::vector<LocalTransform> frames;  // one a frame; empty: it stays at rest
};

/// One animation of a file.
struct NodeTake {
  std::string name;
  std::vector<AnimatedNode> nodes;  // parents first; leaves that draw or light need not be in it
  int frames = 1;
  double sample_rate_hz = 30;
  double cm_per_unit = 1;
  UpAxis up = UpAxis::Y;
  std::vector<NodeMesh> meshes;
  ScalarTracks tracks;  // of as many frames, but for scales, which the nodes have
};

/// Where a node is in the world, in cm with Y up. `rotation` leaves out what its scale and those
/// above it do.
struct NodePlacement {
  Eigen::Matrix3d world_from_node;  // with scale
  Eigen::Vector3d origin;
  Eigen::Quaterniond rotation;
  // For children that do not take over the whole scale: world_from_node = without_scale * scale.
  Eigen::Matrix3d without_scale;
  Eigen::Vector3d scale;
};

/// Where the file's own axes are: what hangs from nothing is below this.
NodePlacement file_placement(double cm_per_unit, UpAxis up);

NodePlacement below(const NodePlacement& parent, const LocalTransform& local);

/// Throws InputError where a clip may not hold so many frames of so many moving nodes. To be asked
/// before NodeTake is filled, as `frames` comes from a file.
void check_take_size(const std::string& file, std::size_t moving_nodes, double frames);

/// The motion of a take. `options` may say another unit or axis than the take does.
///
/// Joints are the nodes marked as such, what moves above or below these, and what lies between. In
/// a file that marks none they are what moves, what hangs from that, and what joins it. Nodes above
/// that stand still become part of the root; where joints are marked, a still leaf below one, alone
/// there, is the end of its bone.
///
/// A joint has no scale: the places of joints are kept exactly, by offsets and, where they change
/// against the parent, by translation channels. The skin has the scales of the first frame; where
/// these change, they are tracks, and a warning says so. Throws InputError.
MotionFile motion_of(const std::string& file, const NodeTake& take, const ReadOptions& options,
                     SourceFormat::Kind kind);

/// What a take looks like, whether it moves or not. Throws InputError where no mesh hangs on
/// joints.
Character character_of(const std::string& file, const NodeTake& take);

/// For each joint of that motion, the node of the take that it is.
std::vector<std::size_t> nodes_of_joints(const std::string& file, const NodeTake& take);

/// "mixamorig:Hips" is Hips where all names are of mixamorig: as motion_of() names its joints.
std::vector<std::string> without_namespace(std::vector<std::string> names);

}  // namespace mocapress
