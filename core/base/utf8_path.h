// SPDX-License-Identifier: MIT
// Converts file names between paths and UTF-8, which is their form in texts, journals and messages.
// Windows has wide characters, and takes narrow characters for those of a code page, so all
// conversions go through these functions.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/error.h"

namespace mocapress {

/// The path with a name in UTF-8. POSIX takes any bytes; Windows throws InputError for bytes that
/// are not UTF-8.
inline std::filesystem::path utf8_path(std::string_view name) {
  try {
    return std::u8string_view(reinterpret_cast<const char8_t*>(name.data()), name.size());
  } catch (const std::system_error&) {
    throw InputError(std::string(name), 0, 0, "is a name that is not UTF-8");
  }
}

inline std::optional<std::filesystem::path> utf8_path_if(const std::optional<std::string>& name) {
  return name ? std::optional(utf8_path(*name)) : std::nullopt;
}

inline std::vector<std::filesystem::path> utf8_paths(const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& name : names) paths.push_back(utf8_path(name));
  return paths;
}

/// The path as text in UTF-8. Throws InputError for a name that Windows allows but UTF-8 cannot
/// express.
inline std::string utf8(const std::filesystem::path& path) {
  try {
    const std::u8string text = path.u8string();
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  } catch (const std::system_error&) {
    throw InputError("a file", 0, 0, "has a name with half a surrogate pair, which no text holds");
  }
}

/// Like utf8(), with slashes between folders on every system.
inline std::string generic_utf8(const std::filesystem::path& path) {
  std::string text = utf8(path);
  if constexpr (std::filesystem::path::preferred_separator != '/')
    for (char& letter : text)
      if (letter == '\\') letter = '/';
  return text;
}

}  // namespace mocapress
