// SPDX-License-Identifier: MIT
#include "core/formats/clip_files.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/formats/text_cursor.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtensions[] = {".bvh", ".amc", ".fbx", ".gltf", ".glb"};

std::vector<fs::path> clips_below(const fs::path& folder) {
  std::vector<fs::path> clips;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (is_clip(entry.path()) && entry.is_regular_file()) clips.push_back(entry.path());
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(), 0, 0, error.code().message());
  }
  if (clips.empty())
    throw InputError(folder.string(), 0, 0, "holds none of " + readable_extensions(", "));
  std::sort(clips.begin(), clips.end());
  return clips;
}

}  // namespace

std::string readable_extensions(std::string_view between, std::string_view before) {
  std::string text;
  for (const std::string_view extension : kExtensions) {
    if (!text.empty()) text += between;
    text.append(before).append(extension);
  }
  return text;
}

bool is_clip(const fs::path& path) {
  const std::string extension = path.extension().string();
  return std::any_of(std::begin(kExtensions), std::end(kExtensions), [&](std::string_view known) {
    return equals_ignoring_case(extension, known);
  });
}

std::vector<fs::path> find_clips(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> clips;
  std::set<fs::path> found;
  const auto add = [&](const fs::path& clip) {
    if (found.insert(clip).second) clips.push_back(clip);
  };
  for (const fs::path& input : inputs) {
    std::error_code error;
    const fs::file_status status = fs::status(input, error);
    if (!fs::exists(status)) throw InputError(input.string(), 0, 0, "No such file or directory");
    if (!fs::is_directory(status))
      add(input);
    else
      for (const fs::path& clip : clips_below(input)) add(clip);
  }
  return clips;
}

}  // namespace mocapress
