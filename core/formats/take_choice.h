// SPDX-License-Identifier: MIT
// Chooses among the animations of a file that has several (FBX, glTF).
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
  bool moves = true;  // true: moves a node
};

/// The index of the take with the name `wanted` or, counted from 1, that number. By default the
/// first that moves a node, else 0. A warning names the takes that are not read. Throws InputError;
/// for a file without takes it says that the file may be a character.
std::size_t choose_take(const std::string& file, const std::vector<TakeName>& takes,
                        const std::optional<std::string>& wanted, Warnings& warnings);

/// The takes that can be chosen: those that move a node, and the one that was `chosen`. Each has
/// its name as key, or its number if an earlier one has the same name.
Takes choices(const std::vector<TakeName>& takes, std::size_t chosen);

}  // namespace mocapress
