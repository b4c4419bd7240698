// SPDX-License-Identifier: MIT
// glTF 2.0, as .glb or as a .gltf with its buffer inside: metres, Y up.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress {

enum class GltfContainer { Gltf, Glb };

/// A skeleton and one animation, without a mesh: nodes that are the joints of a skin, for importers
/// make an armature of these; leaves where bones end; a linear rotation track for each joint that
/// turns, and a translation track where one moves. The bones rest where all channels are zero or,
/// of a source that has no such pose (FBX, glTF), as in the first frame. Throws WriteError where
/// glTF cannot hold so much.
/// Of `tracks` it has the scales of joints.
std::string gltf_bytes(const Motion& motion, GltfContainer container,
                       const SourceFormat& source = {}, const WriteOptions& options = {},
                       const ScalarTracks& tracks = {});

/// The unit and the axes of a file: metres and Y up or, where the source was a glTF, as that had
/// them; unless asked otherwise.
SourceFormat gltf_format(const SourceFormat& source, const WriteOptions& options = {});

/// How gltf_bytes() names the joints, no two alike.
std::vector<std::string> gltf_names(const Skeleton& skeleton);

/// The file `onto` with `motion` in place of the animation that read_gltf() takes from it by
/// `options.take`: the nodes that have the names of its joints move as these do in the world, and
/// scales and morph weights are those of `tracks`, where it has them. All else stays: meshes,
/// materials, other animations, and what the animation does to other nodes. `folder` is where the
/// result will be: when `onto` is in another, the files beside it that it refers to go into the
/// result. A .glb has all buffers in its chunk. Throws InputError, WriteError.
std::string gltf_bytes_onto(const std::filesystem::path& onto, const Motion& motion,
                            GltfContainer container, const std::filesystem::path& folder,
                            const SourceFormat& source = {}, const WriteOptions& options = {},
                            const ScalarTracks& tracks = {});

}  // namespace mocapress
