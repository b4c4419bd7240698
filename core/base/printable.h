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

/// A name for a message, which its reader should see the end of: at most 40 bytes, "..." the last
/// three of a longer one.
std::string shortened(const std::string& name);

}  // namespace mocapress
