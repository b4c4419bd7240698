// SPDX-License-Identifier: MIT
// Files with several animations (FBX, glTF): which of them is meant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/formats/motion_file.h"

namespace mocapress {

/// An animation of a file.
struct TakeName {
  std::string name;
  bool moves = true;  // some node
};

/// The index of the take with that name or, counted from 1, of that number; by default of the first
/// that moves a node, else 0. Those that are not read are named in a warning. Throws InputError: of
/// no takes at all it says that the file may be a character.
std::size_t choose_take(const std::string& file, const std::vector<TakeName>& takes,
                        const std::optional<std::string>& wanted, Warnings& warnings);

/// What can be chosen: the takes that move a node, and the one that was `chosen`. Each by its name,
/// or by its number where one before has the same name.
Takes choices(const std::vector<TakeName>& takes, std::size_t chosen);

}  // namespace mocapress
