// SPDX-License-Identifier: MIT
// Makes names from files safe to print. Terminals obey escape sequences, which can set the title or
// colours, and marks that change the direction of text.
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// Returns a text from a file as one printable line. Control characters become "\x1b" and the like;
/// Unicode's marks that change the direction of text become "\u202e" and the like.
std::string printable(std::string_view text);

/// Shortens a name to at most 40 bytes, so that the end of a message with it stays visible. A name
/// that was cut ends with "...".
std::string shortened(const std::string& name);

}  // namespace mocapress
