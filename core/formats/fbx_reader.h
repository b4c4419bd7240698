// SPDX-License-Identifier: MIT
// Autodesk FBX, binary or ASCII, from version 7.1 on, as assimp reads it. Compiled without assimp
// (MOCAPRESS_FBX=OFF), reading fails with a sentence that says so.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/motion_file.h"

namespace mocapress {

/// Reads the bytes of a .fbx; `file` names it in messages. Of several takes the first with keys is
/// read unless options name another. Keys are sampled at the rate they were made at, or the one
/// that options want; between keys places and scales go straight, rotations along the shortest way.
/// Throws InputError.
MotionFile read_fbx(const std::string& file, std::string_view bytes,
                    const ReadOptions& options = {});

/// What the figure looks like at rest, whatever takes there are. Throws InputError.
Character read_fbx_character(const std::string& file, std::string_view bytes);

}  // namespace mocapress
