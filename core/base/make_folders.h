// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace mocapress {

/// Makes a folder and those above it that are missing. Each new name is on the disk when this
/// returns, so that a power cut takes no folder away from files that are safe in it. Throws
/// WriteError.
void make_folders(const std::filesystem::path& folder);

}  // namespace mocapress
