// SPDX-License-Identifier: MIT
#include "core/batch/item_list.h"

#include <algorithm>
#include <filesystem>

#include "core/batch/format_options_json.h"
#include "core/report/verdict.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// The length of a path's folder, including the last separator.
std::size_t folder_length(const std::string& path) {
  constexpr const char* kSeparators = fs::path::preferred_separator == '/' ? "/" : "/\\";
  return path.find_last_of(kSeparators) + 1;  // npos + 1 is 0
}

/// The options as JSON text; empty if unset.
std::string reading_text(const std::optional<ReadOptions>& reading) {
  if (!reading) return {};
  Json json = Json::object();
  put(json, *reading);
  return dumped(json);
}

std::optional<ReadOptions> reading_in(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return format_options(parse_json("", text));
}

std::string notes_text(const std::vector<FrameNote>& notes) {
  return notes.empty() ? std::string() : dumped(to_json(notes));
}

}  // namespace

ItemList::ItemList(std::initializer_list<BatchItem> items) {
  for (const BatchItem& item : items) push_back(item);
}

/// Stores an item. Zeros end its fields: file names cannot hold a zero, and a problem or note with
/// a zero is cut there.
ItemList::Place ItemList::append(const BatchItem& item) {
  const Place place{text_.size(), index_of_folder(item.input), index_of_folder(item.output)};
  for (const std::string& field :
       {item.input.substr(folder_length(item.input)), item.skeleton,
        item.output.substr(folder_length(item.output)), std::to_string(item.preset), item.problem,
        std::string(name(item.review.verdict)), item.review.note, item.review.reviewer,
        item.review.time, item.review.source_hash, item.review.settings_hash,
        notes_text(item.review.notes), reading_text(item.reading)}) {
    text_ += field.c_str();
    text_ += '\0';
  }
  return place;
}

/// Returns the index of a path's folder; adds the folder if it is new. Searches only the last few
/// folders, since clips come folder by folder: a folder may be stored more than once.
std::uint32_t ItemList::index_of_folder(const std::string& path) {
  constexpr std::ptrdiff_t kLooked = 4;
  const std::string folder = path.substr(0, folder_length(path));
  const auto first = folders_.end() - std::min(kLooked, std::ssize(folders_));
  const auto found = std::find(first, folders_.end(), folder);
  const auto index = static_cast<std::uint32_t>(found - folders_.begin());
  if (found == folders_.end()) folders_.push_back(folder);
  return index;
}

void ItemList::push_back(const BatchItem& item) {
  places_.push_back(append(item));
}

/// The replaced text stays in memory, since few items are replaced.
void ItemList::replace(std::size_t index, const BatchItem& item) {
  places_[index] = append(item);
}

void ItemList::erase(std::size_t index) {
  places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(index));
}

void ItemList::shrink() {
  text_.shrink_to_fit();
  folders_.shrink_to_fit();
  places_.shrink_to_fit();
}

BatchItem ItemList::operator[](std::size_t index) const {
  const Place& place = places_[index];
  const char* at = text_.data() + place.offset;
  const auto next = [&at] {
    std::string field(at);
    at += field.size() + 1;
    return field;
  };
  BatchItem item;
  item.input = folders_[place.input_folder] + next();
  item.skeleton = next();
  item.output = folders_[place.output_folder] + next();
  item.preset = std::stoul(next());
  item.problem = next();
  item.review.verdict = verdict_named(next());
  item.review.note = next();
  item.review.reviewer = next();
  item.review.time = next();
  item.review.source_hash = next();
  item.review.settings_hash = next();
  if (const std::string notes = next(); !notes.empty())
    item.review.notes = frame_notes_from(parse_json("", notes));
  item.reading = reading_in(next());
  return item;
}

bool ItemList::operator==(const ItemList& other) const {
  if (size() != other.size()) return false;
  for (std::size_t i = 0; i < size(); ++i)
    if ((*this)[i] != other[i]) return false;
  return true;
}

}  // namespace mocapress
