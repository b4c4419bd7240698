// SPDX-License-Identifier: MIT
// Reads Autodesk FBX files, binary or ASCII, of version 6.0 or later.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/motion_file.h"

namespace mocapress {

/// Reads the bytes of a .fbx; `file` names it in messages. Reads the first take that moves
/// something, unless options name another. Curves are evaluated by FBX's rules, at the rate of
/// their keys or the one in the options. Throws InputError.
MotionFile read_fbx(const std::string& file, std::string_view bytes,
                    const ReadOptions& options = {});

/// Reads the figure at rest, whatever takes the file has. Throws InputError.
Character read_fbx_character(const std::string& file, std::string_view bytes);

}  // namespace mocapress
