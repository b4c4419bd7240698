// SPDX-License-Identifier: MIT
// Autodesk FBX, binary or ASCII, from version 6.0 on.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/motion_file.h"

namespace mocapress {

/// Reads the bytes of a .fbx; `file` names it in messages. Of several takes the first that moves
/// something is read unless options name another. Curves are evaluated as the file says, at the
/// rate their keys were made at, or the one that options want. Throws InputError.
MotionFile read_fbx(const std::string& file, std::string_view bytes,
                    const ReadOptions& options = {});

/// What the figure looks like at rest, whatever takes there are. Throws InputError.
Character read_fbx_character(const std::string& file, std::string_view bytes);

}  // namespace mocapress
