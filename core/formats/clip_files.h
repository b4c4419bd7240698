// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/file_identity.h"

namespace mocapress {

/// The extensions that read_motion() reads, for messages and file dialogs. Each follows `before`,
/// and `between` separates them: ".bvh, .amc, .fbx, ..." for ", " and "", "*.bvh *.amc *.fbx ..."
/// for " " and "*".
std::string readable_extensions(std::string_view between, std::string_view before = "");

/// True if read_motion() reads files with this extension, in upper or lower case.
bool is_clip(const std::filesystem::path& path);

/// A clip below a folder, or a folder that could not be searched.
struct FoundClip {
  std::filesystem::path path;
  std::string problem;  // reason why it cannot be read, if known already; else empty
};

/// Every clip below a folder, in the order of their paths. Follows links, and searches each folder
/// once, under its own path if that is below `folder`. The list includes, with their problems,
/// folders that cannot be read, clips' names that belong to no file, and links that lead nowhere.
/// Skips the folder `left_out`.
std::vector<FoundClip> clips_below(const std::filesystem::path& folder,
                                   const std::optional<FileIdentity>& left_out = {});

/// The clips that a user names: files as given, and for a folder every clip below it, in the order
/// of their names. Throws InputError if an input is absent, holds no clip or has a folder that
/// cannot be read.
std::vector<std::filesystem::path> find_clips(const std::vector<std::filesystem::path>& inputs);

}  // namespace mocapress
