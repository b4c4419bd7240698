// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress {

inline constexpr int kUsualFbxVersion = 7400;

/// A binary FBX of a skeleton with one take and no mesh: limbs with their bind pose, bone ends as
/// limbs of their own, linear curves with a key for each frame. Each joint rotates in the order of
/// its channels, or XYZ if it has no three; angles take the shorter way between keys. Bones rest as
/// in gltf_bytes(), with the first root at the origin.
///
/// Tracks become scales of joints, weights of blend shapes (whose meshes have no points, since a
/// clip has none), visibility and custom properties of the node that they name; tracks without a
/// node go to the first joint.
///
/// `version` is 7400, or 7700 for files above 4 GiB. Equal motions give equal bytes. Throws
/// WriteError.
std::string fbx_bytes(const Motion& motion, const SourceFormat& source = {},
                      const WriteOptions& options = {}, const ScalarTracks& tracks = {},
                      int version = kUsualFbxVersion);

/// Unit and axes of the file to write: an FBX source's own, else centimetres and the source's up
/// axis; options override both.
SourceFormat fbx_format(const SourceFormat& source, const WriteOptions& options = {});

/// The names of the joints in fbx_bytes(): their own, changed only where two are alike.
std::vector<std::string> fbx_names(const Skeleton& skeleton);

}  // namespace mocapress
