// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mocapress {

/// What read_motion() reads, for messages and file dialogs: ".bvh, .amc, .fbx, ..." with ", "
/// between and nothing before each; "*.bvh *.amc *.fbx ..." with " " and "*".
std::string readable_extensions(std::string_view between, std::string_view before = "");

/// Whether the extension is one of these, in any case.
bool is_clip(const std::filesystem::path& path);

/// The clips a user names: files as they are, and of folders every clip below them, in the order of
/// their names. Throws InputError when one is not there or holds no clip.
std::vector<std::filesystem::path> find_clips(const std::vector<std::filesystem::path>& inputs);

}  // namespace mocapress
