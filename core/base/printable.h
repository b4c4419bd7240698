// SPDX-License-Identifier: MIT
// Makes names from files safe to print, since terminals obey escape sequences that set their title
// or colours, and marks that turn the direction of text.
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// One printable line from the contents of a file: control characters become "\x1b" and the like,
/// and Unicode's that change the direction of text "\u202e".
std::string printable(std::string_view text);

/// Shortens a name for a message, so that the end of the message stays visible: at most 40 bytes,
/// of which the last three are "..." if the name is longer.
std::string shortened(const std::string& name);

}  // namespace mocapress
