// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The bytes of a file in which `motion` replaces the take that read_fbx() reads by `options.take`.
/// If no take has a key, the motion becomes the first one. Nodes with the names of the motion's
/// joints move as these do in the world. Weights, properties and scales come from `tracks`, where
/// it has them. A curve gets a key each frame, from the time of the take's first frame on; a curve
/// that already agrees with the motion stays. Everything else stays, byte by byte: meshes,
/// materials, other takes and their layers. Unit and axes are the file's own, unless options
/// override them. The file must be a binary FBX from version 7.0 on; `file` names it in messages.
/// Throws InputError, WriteError.
std::string fbx_bytes_onto(const std::string& file, std::string_view bytes, const Motion& motion,
                           const WriteOptions& options = {}, const ScalarTracks& tracks = {});

}  // namespace mocapress
