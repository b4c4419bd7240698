// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress {

inline constexpr int kUsualFbxVersion = 7400;

/// One take of a file to be written.
struct FbxClip {
  std::string take;
  const Motion& motion;
  const ScalarTracks& tracks;
};

/// A binary FBX of a skeleton and its takes, without a mesh: limb nodes with their bind pose,
/// further limb nodes for the ends of bones, and linear curves with a key each frame. Each joint
/// turns in the order of its three rotation channels, or else in the order XYZ; no angle takes the
/// longer way round from key to key. Bones rest as gltf_bytes() would write them for the first
/// clip, with the first root at the origin. All clips are of one rig (rig_of()), each at its own
/// rate.
///
/// Tracks become scales of joints, weights of blend shapes (whose meshes have no points, since a
/// clip has none), visibility and custom properties of the node that they name; tracks without a
/// node go to the first joint.
///
/// The version is that of the options, or 7.4. The same clips make the same bytes. Throws
/// WriteError.
std::string fbx_bytes(const std::vector<FbxClip>& clips, const SourceFormat& source = {},
                      const WriteOptions& options = {});

/// The bytes of a file with one clip.
std::string fbx_bytes(const Motion& motion, const SourceFormat& source = {},
                      const WriteOptions& options = {}, const ScalarTracks& tracks = {});

/// Unit and axes of the file to write: an FBX source's own, else centimetres and the source's up
/// axis; options override both.
SourceFormat fbx_format(const SourceFormat& source, const WriteOptions& options = {});

/// The unique joint names that fbx_bytes() writes; a joint without a name is called "joint".
std::vector<std::string> fbx_names(const Skeleton& skeleton);

}  // namespace mocapress
