// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/file_identity.h"

namespace mocapress {

/// What read_motion() reads, for messages and file dialogs: ".bvh, .amc, .fbx, ..." with ", "
/// between and nothing before each; "*.bvh *.amc *.fbx ..." with " " and "*".
std::string readable_extensions(std::string_view between, std::string_view before = "");

/// Whether the extension is one of these, in any case.
bool is_clip(const std::filesystem::path& path);

/// A clip below a folder, or what could not be looked into.
struct FoundClip {
  std::filesystem::path path;
  std::string problem;  // why it cannot be read, known beforehand; else empty
};

/// Every clip below a folder, in the order of their paths. Links are followed, and each folder is
/// looked into once, by its own path where it has one below `folder`. A folder that cannot be read,
/// a clip's name that belongs to no file and a link that leads nowhere are in the list with their
/// problem. `left_out` is a folder that is not looked into.
std::vector<FoundClip> clips_below(const std::filesystem::path& folder,
                                   const std::optional<FileIdentity>& left_out = {});

/// The clips a user names: files as they are, and of folders every clip below them, in the order of
/// their names. Throws InputError when one is not there, holds no clip or a folder that cannot be
/// read.
std::vector<std::filesystem::path> find_clips(const std::vector<std::filesystem::path>& inputs);

}  // namespace mocapress
