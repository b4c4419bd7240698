// SPDX-License-Identifier: MIT
#include "core/formats/clip_files.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include "core/base/error.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

bool is_clip(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".bvh" || extension == ".amc";
}

std::vector<fs::path> clips_below(const fs::path& folder) {
  std::vector<fs::path> clips;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (is_clip(entry.path()) && entry.is_regular_file()) clips.push_back(entry.path());
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(), 0, 0, error.code().message());
  }
  if (clips.empty()) throw InputError(folder.string(), 0, 0, "holds no .bvh and no .amc");
  std::sort(clips.begin(), clips.end());
  return clips;
}

}  // namespace

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
