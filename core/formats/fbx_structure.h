// SPDX-License-Identifier: MIT
// What assimp takes for granted: it calls itself for each level of records and of nodes, so a file
// of few bytes, with nodes that hang from one another in a circle, would end the program.
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// Throws InputError where records or nodes nest deeper than a stack bears, or nodes are too many.
/// What else may be wrong with the bytes is left to who reads them.
void check_fbx_structure(const std::string& file, std::string_view bytes);

}  // namespace mocapress
