// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace mocapress::cli {

/// Throws WriteError if `output` would overwrite a source or cannot be written. Call it before the
/// work starts, so that none is wasted.
void require_place(const std::filesystem::path& output,
                   const std::vector<std::filesystem::path>& sources);

}  // namespace mocapress::cli
