// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace mocapress::test {

/// The answer of a process that lacks the rights for a test.
inline constexpr const char* kSkip = "skip";

/// Runs `work` in a process of its own, which may change its user, limits and mounts, and returns
/// its answer, or "threw: ..." or "killed by ...".
std::string in_own_process(const std::function<std::string()>& work);

// The functions below are called in that process. They return false if they are not allowed.

/// Mounts an empty disk of `bytes` bytes at a folder, which no other process sees.
bool mount_small_disk(const std::filesystem::path& folder, std::size_t bytes);

/// Limits the size of files; a write beyond it fails.
bool limit_file_size(std::size_t bytes);

/// Continues as a user to whom permissions apply: root becomes nobody.
bool become_ordinary_user();

}  // namespace mocapress::test
