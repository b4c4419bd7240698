// SPDX-License-Identifier: MIT
// Tells what is at a path, by stat(2).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

enum class PathKind { Absent, File, Folder, Other };

/// The kind of the file at the end of a path's links. Absent only if the system says that nothing
/// is there: any other failure, such as a disk that does not answer, throws InputError.
PathKind path_kind(const std::filesystem::path& path);

/// True if there is anything at the path. Throws InputError as path_kind() does.
bool is_there(const std::filesystem::path& path);

/// True if two paths lead to the same file; false if either is absent. Throws InputError as
/// path_kind() does.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// The absolute path with all links resolved, as realpath(3) gives it. Unset if nothing is there.
std::optional<std::filesystem::path> real_path(const std::filesystem::path& path);

/// A key that is equal for two names which the system takes for the same file in a folder: Windows
/// ignores the case of letters. `name` is UTF-8.
std::string name_key(std::string_view name);

}  // namespace mocapress
