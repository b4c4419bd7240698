// SPDX-License-Identifier: MIT
// The step that FBX and glTF share: from a tree of nodes that move, turn and scale to a skeleton of
// joints, most of which only turn.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "core/formats/local_frames.h"
#include "core/formats/motion_file.h"
#include "core/formats/node_skin.h"

namespace mocapress {

struct AnimatedNode {
  std::string name;
  int parent = -1;     // comes before its children; -1: none
  bool joint = false;  // true: the file marks it as a joint; false: unknown
  LocalTransform rest;
  LocalFrames frames;  // one for each frame; empty: it stays at rest
};

/// One animation of a file.
struct NodeTake {
  std::string name;
  std::vector<AnimatedNode> nodes;  // parents first; leaves that draw or light may be left out
  int frames = 1;
  double sample_rate_hz = 30;
  double cm_per_unit = 1;
  UpAxis up = UpAxis::Y;
  std::vector<NodeMesh> meshes;
  ScalarTracks tracks;  // one value a frame; without scales, which the nodes have
};

/// The placement of a node in the world, in cm with Y up. `rotation` excludes the effect of scales,
/// its own and those above.
struct NodePlacement {
  Eigen::Matrix3d world_from_node;  // including scale
  Eigen::Vector3d origin;
  Eigen::Quaterniond rotation;
  // For children that do not inherit the whole scale: world_from_node = without_scale * scale.
  Eigen::Matrix3d without_scale;
  Eigen::Vector3d scale;
};

/// The placement of the file's own axes in the world. Nodes without a parent are placed below it.
NodePlacement file_placement(double cm_per_unit, UpAxis up);

NodePlacement below(const NodePlacement& parent, const LocalTransform& local);

/// Throws InputError if a clip may not hold this number of frames of this number of moving nodes.
/// Call it before filling a NodeTake, since `frames` comes from a file.
void check_take_size(const std::string& file, std::size_t moving_nodes, double frames);

/// The motion of a take. `options` may override its unit or axis.
///
/// Joints are the nodes marked as such, nodes that move above or below these, and nodes between. In
/// a file that marks none, joints are the nodes that move, everything below these, and the nodes
/// that join them. Still nodes above become part of the root. Where joints are marked, a still leaf
/// that is the only child of one is the end of its bone.
///
/// A joint has no scale: joints keep their exact places by offsets and, if these change relative to
/// the parent, by translation channels. The skin has the scales of the first frame. Scales that
/// change become tracks, and a warning says so. Throws InputError.
MotionFile motion_of(const std::string& file, const NodeTake& take, const ReadOptions& options,
                     SourceFormat::Kind kind);

/// The mesh of a take with its skeleton, moving or not. Throws InputError if no mesh is bound to
/// joints.
Character character_of(const std::string& file, const NodeTake& take);

/// For each joint of motion_of(), the index of the take's node that it comes from.
std::vector<std::size_t> nodes_of_joints(const std::string& file, const NodeTake& take);

/// Drops a namespace that all names share: "mixamorig:Hips" becomes Hips, as motion_of() names its
/// joints.
std::vector<std::string> without_namespace(std::vector<std::string> names);

}  // namespace mocapress
