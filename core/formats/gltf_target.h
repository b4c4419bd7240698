// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "core/formats/gltf_file.h"

namespace mocapress {

/// A node's property that an animation can move.
enum class GltfPath { Translation, Rotation, Scale, Weights };

struct GltfTarget {
  std::size_t node;  // its index in the file
  GltfPath path;
};

/// The node and property that a channel of an animation moves, named by the channel itself or by
/// KHR_animation_pointer ("/nodes/1/rotation"). Unset: the channel moves something else, as
/// extensions allow. Throws InputError.
std::optional<GltfTarget> gltf_target(const GltfFile& file, const Json& channel);

}  // namespace mocapress
