// SPDX-License-Identifier: MIT
#include "core/batch/project_batch.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/utf8_path.h"
#include "core/batch/format_options_json.h"
#include "core/formats/text_cursor.h"
#include "core/mocapress/settings_json.h"
#include "core/report/verdict.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr int kNewestProject = 1;

/// Reads a path. Projects store paths relative to their folder. Empty if the key is absent.
std::string path_at(const Json& json, const char* key, const fs::path& folder) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return "";
  const auto text = found->get<std::string>();
  return text.empty() ? "" : utf8((folder / utf8_path(text)).lexically_normal());
}

/// The value of {folder} in names: the folders from the project to the clip, or the name of the
/// clip's own folder if it is not below the project's.
std::string folder_of(const fs::path& clip, const fs::path& project_folder) {
  const fs::path below = clip.parent_path().lexically_relative(
      project_folder.empty() ? fs::path(".") : project_folder.lexically_normal());
  if (below.empty() || *below.begin() == "..") return utf8(clip.parent_path().filename());
  return below == "." ? "" : generic_utf8(below);
}

/// Settings of a clip in a project. They get a name if they have none, since rows of a batch need
/// one.
Settings settings_of_clip(Json json) {
  json.erase("contact_settings");  // belongs to the studio's search for contacts
  Settings settings = settings_from(json);
  if (settings.name.empty()) settings.name = "Project";
  return settings;
}

std::size_t index_of(const Settings& settings, std::vector<Settings>& presets) {
  const auto found = std::ranges::find(presets, settings);
  const auto index = static_cast<std::size_t>(found - presets.begin());
  if (found == presets.end()) presets.push_back(settings);
  return index;
}

/// Reads the project's characters, by the names of rigs.
std::map<std::string, std::string> characters_in(const Json& json, const fs::path& folder) {
  std::map<std::string, std::string> characters;
  if (const auto by_rig = json.find("characters"); by_rig != json.end())
    for (const auto& [rig, path] : by_rig->items())
      characters[rig] = path_at(*by_rig, rig.c_str(), folder);
  return characters;
}

/// The character to put on a clip; empty: the clip keeps its own. A clip whose rig the project does
/// not know yet gets the project's character if there is only one. If that does not fit, the clip
/// keeps its own later, with a warning.
std::string character_on(const Json& clip, const std::map<std::string, std::string>& characters) {
  const std::string rig = clip.value("rig", "");
  if (rig.empty() && characters.size() == 1) return characters.begin()->second;
  const auto found = characters.find(rig);
  return found == characters.end() ? "" : found->second;
}

void add_clip(Batch& batch, const Json& json, const fs::path& folder,
              const std::map<std::string, std::string>& characters, std::string_view pattern) {
  const std::string path = path_at(json, "path", folder);
  if (path.empty()) throw Error("has a clip without a path");
  std::size_t preset = 0;
  if (const auto settings = json.find("settings"); settings != json.end())
    preset = index_of(settings_of_clip(*settings), batch.presets);
  const auto reading = json.find("reading");
  const ReadOptions options = reading != json.end() ? format_options(*reading) : ReadOptions();
  const SourceClip source{path, folder_of(utf8_path(path), folder), {}, options.take.value_or("")};
  add_items(batch, {source}, preset, pattern);
  const std::size_t last = batch.items.size() - 1;
  BatchItem item = batch.items[last];
  item.skeleton = path_at(json, "skeleton", folder);
  if (reading != json.end()) {
    item.reading = options;
    item.reading->character = batch.reading.character;
  }
  if (const std::string character = character_on(json, characters);
      !character.empty() && !batch.reading.character) {
    if (!item.reading) item.reading = batch.reading;
    item.reading->character = character;
  }
  item.review = review_from(json);
  batch.items.replace(last, item);
}

}  // namespace

bool is_project_file(const std::string& path) {
  return equals_ignoring_case(utf8(utf8_path(path).extension()), ".mocapress");
}

void add_project(Batch& batch, const std::string& file, const std::string& text,
                 std::string_view pattern) {
  output_name(pattern, {"clip.bvh", "folder", {}}, batch.presets.front());
  const Json json = parse_json(file, text);
  const fs::path folder = utf8_path(file).parent_path();
  try {
    if (!json.is_object() || json.value("format", "") != "mocapress-project")
      throw Error("is not a project");
    if (json.value("version", 0) > kNewestProject)
      throw Error("was saved by a newer version of Mocapress");
    const std::map<std::string, std::string> characters = characters_in(json, folder);
    if (const auto clips = json.find("clips"); clips != json.end())
      for (const Json& clip : *clips) add_clip(batch, clip, folder, characters, pattern);
  } catch (const Json::exception& error) {
    throw InputError(file, 0, 0, std::string("is not a project: ") + error.what());
  } catch (const Error& error) {
    throw InputError(file, 0, 0, error.what());
  }
}

}  // namespace mocapress
