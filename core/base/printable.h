// SPDX-License-Identifier: MIT
// Names come from files, and a terminal obeys what stands in them: escape sequences that set its
// title or colours, marks that turn the direction of what follows.
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// One line of what a file holds, for people: control characters as "\x1b", and those of Unicode
/// that change the direction of text as "\u202e".
std::string printable(std::string_view text);

}  // namespace mocapress
