// SPDX-License-Identifier: MIT
#include "core/formats/clip_files.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/base/folder_listing.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/formats/text_cursor.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtensions[] = {".bvh", ".amc", ".fbx", ".gltf",
                                            ".glb", ".vrm", ".vrma"};

class FolderWalk {
 public:
  explicit FolderWalk(const std::optional<FileIdentity>& left_out) {
    if (left_out) seen_.insert(*left_out);
  }

  std::vector<FoundClip> clips_below(const fs::path& folder) {
    look_into(folder);
    // Follows links last, so that a folder is found under its own path if that is below `folder`.
    for (std::size_t i = 0; i < links_.size(); ++i) look_into(fs::path(links_[i]));
    std::ranges::sort(found_, {}, [](const FoundClip& clip) { return generic_utf8(clip.path); });
    return std::move(found_);
  }

 private:
  void look_into(const fs::path& folder) {
    try {
      const std::optional<FileIdentity> identity = identity_of(folder);
      if (identity && !seen_.insert(*identity).second) return;
    } catch (const InputError&) {  // list_folder() reports the reason
    }
    const FolderListing listing = list_folder(folder);
    for (const FolderEntry& entry : listing.entries) look_at(entry);
    if (!listing.problem.empty()) found_.push_back({folder, listing.problem});
  }

  void look_at(const FolderEntry& entry) {
    const fs::path& path = entry.path;
    if (entry.kind == PathKind::Folder) {
      entry.is_link ? links_.push_back(path) : look_into(path);
      return;
    }
    const bool may_be_folder = !entry.problem.empty() && !path.has_extension();
    if (!is_clip(path) && !may_be_folder) return;
    if (entry.is_link && entry.kind == PathKind::Absent)
      return found_.push_back({path, "is a link that leads nowhere"});
    std::string problem = entry.problem;
    if (problem.empty() && entry.kind != PathKind::File) problem = "is not a regular file";
    found_.push_back({path, problem});
  }

  std::vector<FoundClip> found_;
  std::vector<fs::path> links_;  // links to folders
  std::set<FileIdentity> seen_;  // folders already visited
};

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
  const std::string extension = utf8(path.extension());
  return std::ranges::any_of(
      kExtensions, [&](std::string_view known) { return equals_ignoring_case(extension, known); });
}

std::vector<FoundClip> clips_below(const fs::path& folder,
                                   const std::optional<FileIdentity>& left_out) {
  return FolderWalk(left_out).clips_below(folder);
}

std::vector<fs::path> find_clips(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> clips;
  std::set<fs::path> found;
  const auto add = [&](const fs::path& clip) {
    if (found.insert(clip).second) clips.push_back(clip);
  };
  for (const fs::path& input : inputs) {
    const PathKind kind = path_kind(input);
    if (kind == PathKind::Absent) throw InputError(utf8(input), 0, 0, "No such file or directory");
    if (kind != PathKind::Folder) {
      add(input);
      continue;
    }
    const std::vector<FoundClip> below = clips_below(input);
    if (below.empty())
      throw InputError(utf8(input), 0, 0, "holds none of " + readable_extensions(", "));
    for (const FoundClip& clip : below) {
      if (!is_clip(clip.path)) throw InputError(utf8(clip.path), 0, 0, clip.problem);
      add(clip.path);
    }
  }
  return clips;
}

}  // namespace mocapress
