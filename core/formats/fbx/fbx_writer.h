// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress {

inline constexpr int kUsualFbxVersion = 7400;

/// A binary FBX of a skeleton and one take, without a mesh: limbs with their bind pose, bones' ends
/// as limbs of their own, straight curves with a key each frame. Each joint turns in the order of
/// its channels, or XYZ where it has no three; from key to key no angle takes the longer way round.
/// Bones rest as gltf_bytes() has them, the first root at the origin.
///
/// Tracks are scales of joints, weights of blend shapes (of meshes without a point, as a clip has
/// none), visibility and custom properties of the node that they name; those of no node are the
/// first joint's.
///
/// `version` is 7400 or 7700, which holds more than 4 GiB. The same motion makes the same bytes.
/// Throws WriteError.
std::string fbx_bytes(const Motion& motion, const SourceFormat& source = {},
                      const WriteOptions& options = {}, const ScalarTracks& tracks = {},
                      int version = kUsualFbxVersion);

/// The unit and the axes of a file: those of a source that was an FBX, else centimetres and the
/// source's up axis; unless asked otherwise.
SourceFormat fbx_format(const SourceFormat& source, const WriteOptions& options = {});

/// The names that fbx_bytes() gives the joints: their own, but no two alike.
std::vector<std::string> fbx_names(const Skeleton& skeleton);

}  // namespace mocapress
