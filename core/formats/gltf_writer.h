// SPDX-License-Identifier: MIT
// glTF 2.0, as .glb or as a .gltf with its buffer inside: metres, Y up.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress {

enum class GltfContainer { Gltf, Glb };

/// A skeleton and one animation, without a mesh. Nodes are joints of a skin, so that importers make
/// an armature of them; leaves mark the ends of bones. Each joint that turns has a linear rotation
/// track, and one that moves a translation track. Bones rest with all channels at zero or, if the
/// source has no such pose (FBX, glTF), as in the first frame. Among `tracks`, scales of joints are
/// written. Throws WriteError if glTF cannot hold so much.
std::string gltf_bytes(const Motion& motion, GltfContainer container,
                       const SourceFormat& source = {}, const WriteOptions& options = {},
                       const ScalarTracks& tracks = {});

/// The unit and the axes of a file to write: those of the options, else of a source that was a
/// glTF, else metres and Y up.
SourceFormat gltf_format(const SourceFormat& source, const WriteOptions& options = {});

/// The unique joint names that gltf_bytes() writes.
std::vector<std::string> gltf_names(const Skeleton& skeleton);

/// The file `onto` in which `motion` replaces the animation that read_gltf() reads by
/// `options.take`. Nodes with the names of the motion's joints move as these do in the world.
/// Scales and morph weights come from `tracks`, where it has them. Everything else stays: meshes,
/// materials, other animations, and the replaced animation's effect on other nodes. `folder` is the
/// folder of the result: if `onto` is in another, files beside it that it refers to go into the
/// result. A .glb has all buffers in its chunk. Throws InputError, WriteError.
std::string gltf_bytes_onto(const std::filesystem::path& onto, const Motion& motion,
                            GltfContainer container, const std::filesystem::path& folder,
                            const SourceFormat& source = {}, const WriteOptions& options = {},
                            const ScalarTracks& tracks = {});

}  // namespace mocapress
