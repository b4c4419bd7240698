// SPDX-License-Identifier: MIT
// glTF 2.0 as .gltf, .glb or .glb by another name (.vrm, .vrma): metres, Y up. A skeleton consists
// of the nodes that are joints of a skin, or else of those that move (node_motion.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/gltf_file.h"
#include "core/formats/node_motion.h"

namespace mocapress {

inline constexpr double kGltfCmPerUnit = 100;

/// Reads the bytes of a .gltf or .glb. `file` names it in messages; buffers may lie in its folder.
/// Throws InputError.
MotionFile read_gltf(const std::string& file, std::string_view bytes,
                     const ReadOptions& options = {});

/// The mesh of a file with its skeleton at rest, whatever its animations. Throws InputError.
Character read_gltf_character(const std::string& file, std::string_view bytes);

/// One animation of a glTF, as read by read_gltf().
struct GltfTake {
  NodeTake take;
  std::size_t animation = 0;  // its index in the file
  double first_s = 0;         // the time of its first frame
  Takes takes;
  std::vector<std::size_t> number_of_node;  // index in the file for each of take.nodes
  struct Weight {                           // one for each of take.tracks
    std::size_t node;                       // its index in the file
    std::size_t target;                     // its index in the mesh
  };
  std::vector<Weight> weights;
  Warnings warnings;
};

GltfTake read_gltf_take(GltfFile& file, const ReadOptions& options);

}  // namespace mocapress
