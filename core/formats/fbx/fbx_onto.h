// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The file `onto` with `motion` in place of the take that read_fbx() takes from it by
/// `options.take`: the nodes that have the names of its joints move as these do in the world, and
/// weights, properties and scales are those of `tracks`, where it has them. A curve gets a key each
/// frame, from the time of the take's first frame on; a curve that says what the motion says stays.
/// All else stays, byte by byte: meshes, materials, other takes and their layers. `onto` is a
/// binary FBX from version 7.0 on. Throws InputError, WriteError.
std::string fbx_bytes_onto(const std::filesystem::path& onto, const Motion& motion,
                           const SourceFormat& source = {}, const WriteOptions& options = {},
                           const ScalarTracks& tracks = {});

}  // namespace mocapress
