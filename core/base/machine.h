// SPDX-License-Identifier: MIT
// Facts that the system tells about itself, with one body for POSIX and one for Windows.
#pragma once

#include <cstdint>
#include <string>

namespace mocapress {

/// Bytes of memory built in; 0 if the system does not tell.
std::uint64_t physical_memory();

std::string host_name();

/// The user's name, or number if there is no name.
std::string user_name();

/// The number of this process.
long process_number();

}  // namespace mocapress
