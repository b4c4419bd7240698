// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The bytes of a file with `motion` in place of the take that read_fbx() takes from it by
/// `options.take`, or as its first take where none has a key: the nodes that have the names of its
/// joints move as these do in the world, and weights, properties and scales are those of `tracks`,
/// where it has them. A curve gets a key each frame, from the time of the take's first frame on; a
/// curve that says what the motion says stays. All else stays, byte by byte: meshes, materials,
/// other takes and their layers. Unit and axes are its own, unless options tell others. It is a
/// binary FBX from version 7.0 on; `file` names it in messages. Throws InputError, WriteError.
std::string fbx_bytes_onto(const std::string& file, std::string_view bytes, const Motion& motion,
                           const WriteOptions& options = {}, const ScalarTracks& tracks = {});

}  // namespace mocapress
