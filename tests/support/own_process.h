// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace mocapress::test {

/// What a process that may not try something answers.
inline constexpr const char* kSkip = "skip";

/// Runs `work` in a process of its own, whose user, limits and mounts it may change, and gives what
/// it answers; "threw: ..." or "killed by ..." when it comes to no answer.
std::string in_own_process(const std::function<std::string()>& work);

// To be called there. False: not allowed here.

/// Mounts an empty disk of `bytes` at a folder; nobody else sees it.
bool mount_small_disk(const std::filesystem::path& folder, std::size_t bytes);

/// Files may not become larger; a write that would make them fails.
bool limit_file_size(std::size_t bytes);

/// Goes on as somebody to whom permissions apply: root becomes nobody.
bool become_ordinary_user();

}  // namespace mocapress::test
