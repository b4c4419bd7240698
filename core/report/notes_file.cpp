// SPDX-License-Identifier: MIT
#include "core/report/notes_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/report/verdict.h"

namespace mocapress {
namespace {

constexpr const char* kFormat = "mocapress-notes";
constexpr int kVersion = 1;
constexpr JsonLimits kLimits{.depth = 8, .values = 1'000'000};

/// Reads a file of notes. Throws InputError if it has another form.
Json read_json(const std::filesystem::path& file) {
  const Json json = parse_json(utf8(file), read_text(file), kLimits);
  if (!json.is_object() || json.value("format", Json()) != kFormat ||
      !json.value("clip", Json("")).is_string())
    throw InputError(utf8(file), 0, 0, "is no file of notes");
  if (json.value("version", Json()) > kVersion)
    throw InputError(utf8(file), 0, 0, "was written by a newer version of Mocapress");
  return json;
}

/// False if the notes are those of a clip with the same stem but another format. True for a clip
/// that was renamed together with its notes.
bool is_for(const Json& json, const std::filesystem::path& clip) {
  const std::filesystem::path named = utf8_path(json.value("clip", ""));
  return named.stem() != clip.stem() || named.extension() == clip.extension();
}

}  // namespace

std::filesystem::path notes_file_of(const std::filesystem::path& clip) {
  std::filesystem::path file = clip;
  return file.replace_extension(".notes.json");
}

void add_notes(std::vector<FrameNote>& notes, const std::vector<FrameNote>& others) {
  for (const FrameNote& other : others) {
    const auto is_same = [&](const FrameNote& note) {
      return note.frame == other.frame && note.last_frame == other.last_frame &&
             note.joint == other.joint && note.text == other.text &&
             note.reviewer == other.reviewer;
    };
    if (std::ranges::none_of(notes, is_same)) notes.push_back(other);
  }
  std::ranges::stable_sort(notes, {}, &FrameNote::frame);
}

void write_notes(const std::filesystem::path& clip, const NotesByTake& notes) {
  Json takes = Json::object();
  for (const auto& [take, those] : notes)
    if (!those.empty()) takes[take] = to_json(those);
  const std::filesystem::path file = notes_file_of(clip);
  if (is_there(file) && !is_for(read_json(file), clip))
    throw WriteError(utf8(file) + ": holds the notes of a clip in another format");
  if (takes.empty()) {
    std::error_code ignored;  // the file may be absent already, or stay
    std::filesystem::remove(file, ignored);
    return;
  }
  const Json json{{"format", kFormat},
                  {"version", kVersion},
                  {"clip", utf8(clip.filename())},
                  {"takes", takes}};
  write_text(file, dumped(json, 2) + '\n');
}

NotesByTake read_notes(const std::filesystem::path& clip) {
  const std::filesystem::path file = notes_file_of(clip);
  NotesByTake notes;
  if (!is_there(file)) return notes;
  const Json json = read_json(file);
  try {
    if (!is_for(json, clip)) return notes;
    for (const auto& [take, those] : json.at("takes").items()) {
      std::vector<FrameNote>& read = notes[take] = frame_notes_from(those);
      std::erase_if(read,
                    [](const FrameNote& note) { return note.frame < 0 || note.text.empty(); });
      std::ranges::stable_sort(read, {}, &FrameNote::frame);
    }
  } catch (const Json::exception& error) {
    throw InputError(utf8(file), 0, 0, std::string("has notes of another form: ") + error.what());
  }
  return notes;
}

}  // namespace mocapress
