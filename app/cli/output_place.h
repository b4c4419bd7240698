// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace mocapress::cli {

/// Throws WriteError for an output file that would overwrite a source or cannot be written, before
/// work is spent on it.
void require_place(const std::filesystem::path& output,
                   const std::vector<std::filesystem::path>& sources);

}  // namespace mocapress::cli
