// SPDX-License-Identifier: MIT
// Facts about the machine, the user and the process. POSIX and Windows have an implementation each.
#pragma once

#include <cstdint>
#include <string>

namespace mocapress {

/// Bytes of built-in memory; 0 if the system does not tell.
std::uint64_t physical_memory();

std::string host_name();

/// The user's name, or the user's number if there is no name.
std::string user_name();

/// The number of this process.
long process_number();

}  // namespace mocapress
