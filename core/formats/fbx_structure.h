// SPDX-License-Identifier: MIT
// What assimp takes for granted, and what it does not tell.
//
// It calls itself for each level of records and of nodes, so a file
// of few bytes, with nodes that hang from one another in a circle, would end the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mocapress {

/// Throws InputError where records or nodes nest deeper than a stack bears, nodes are too many, two
/// objects are connected twice, which assimp would free twice, or arrays inflate beyond the memory
/// limit.
/// What else may be wrong with the bytes is left to who reads them.
void check_fbx_structure(const std::string& file, std::string_view bytes);

/// Takes that move something in several animation layers, which assimp reads as one: added or
/// overridden values come out wrong.
std::vector<std::string> layered_fbx_takes(std::string_view bytes);

}  // namespace mocapress
