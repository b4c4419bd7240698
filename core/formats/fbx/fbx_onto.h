// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The file `onto` with its take (the one that read_fbx() reads for `options.take`) replaced by
/// `motion`. Nodes with the names of its joints move as these do in the world; weights, properties
/// and scales follow `tracks` where it has them. Curves get a key for each frame, starting at the
/// take's first frame; a curve that already matches stays. Everything else stays byte by byte:
/// meshes, materials, other takes and their layers. `onto` must be a binary FBX of version 7.0 or
/// later. Throws InputError, WriteError.
std::string fbx_bytes_onto(const std::filesystem::path& onto, const Motion& motion,
                           const SourceFormat& source = {}, const WriteOptions& options = {},
                           const ScalarTracks& tracks = {});

}  // namespace mocapress
