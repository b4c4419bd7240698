// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace mocapress::test {

/// The folder of real motions: $MOCAPRESS_CORPUS, or ../shared/corpus beside the source tree. Tests
/// are skipped without it.
inline std::optional<std::filesystem::path> corpus() {
  const char* named = std::getenv("MOCAPRESS_CORPUS");
  const std::filesystem::path folder =
      named ? named : std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "../shared/corpus";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) return std::nullopt;
  return folder.lexically_normal();
}

}  // namespace mocapress::test
