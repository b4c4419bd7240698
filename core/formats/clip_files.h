// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace mocapress {

/// The clips a user names: files as they are, and of folders every .bvh and .amc below them, in the
/// order of their names. Throws InputError when one is not there or holds no clip.
std::vector<std::filesystem::path> find_clips(const std::vector<std::filesystem::path>& inputs);

}  // namespace mocapress
