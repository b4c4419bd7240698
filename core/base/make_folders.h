// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace mocapress {

/// Makes a folder and its missing parents. When this returns, each new name is on the disk, so that
/// a power cut cannot take the folder away from files that were saved in it. Throws WriteError.
void make_folders(const std::filesystem::path& folder);

}  // namespace mocapress
