// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/formats/csv.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"

namespace mocapress {
namespace {

constexpr std::size_t kLongestName = 255;  // bytes, the limit of a track's name in a .mcpr
constexpr std::string_view kTime = "time_s";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct Field {
  std::string_view text;
  int column = 1;  // column in the line, from 1
};

/// Walks a table line by line, skipping empty lines.
class Table {
 public:
  Table(const std::string& file, std::string_view text) : file_(file), rest_(text) {
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  }

  /// The next line's fields; empty at the end.
  std::vector<Field> next() {
    while (!rest_.empty()) {
      const std::size_t size = std::min(rest_.find('\n'), rest_.size());
      const std::string_view line = rest_.substr(0, size);
      rest_.remove_prefix(std::min(size + 1, rest_.size()));
      ++line_;
      if (line.find_first_not_of(kSpace) != std::string_view::npos) return fields_of(line);
    }
    return {};
  }

  [[noreturn]] void fail(int column, const std::string& message) const {
    throw InputError(file_, std::max(line_, 1), column, message);
  }

 private:
  static constexpr std::string_view kSpace = " \t\r";

  static std::vector<Field> fields_of(std::string_view line) {
    std::vector<Field> fields;
    for (std::size_t start = 0; start <= line.size();) {
      const std::size_t end = std::min(line.find(',', start), line.size());
      const std::size_t first = std::min(line.find_first_not_of(kSpace, start), end);
      const std::string_view text = line.substr(first, end - first);
      fields.push_back(
          {text.substr(0, text.find_last_not_of(kSpace) + 1), static_cast<int>(first) + 1});
      start = end + 1;
    }
    return fields;
  }

  const std::string& file_;
  std::string_view rest_;
  int line_ = 0;
};

ScalarTracks tracks_of_head(const Table& table, const std::vector<Field>& head) {
  ScalarTracks tracks;
  std::set<std::string_view> names;
  for (const Field& field : head) {
    if (field.text.empty() || field.text.size() > kLongestName)
      table.fail(field.column, "a column needs a name of 1 to 255 bytes");
    if (field.text.find('"') != std::string_view::npos)
      table.fail(field.column, "a name of a column has no quotes");
    if (!names.insert(field.text).second)
      table.fail(field.column, "two columns are called " + quoted({field.text}));
    tracks.push_back({.node = "", .name = std::string(field.text), .values = {}});
  }
  return tracks;
}

float value_of(const Table& table, const Field& field) {
  const auto number = parse_number(field.text);
  const auto value = static_cast<float>(number.value_or(0));
  if (!number || !std::isfinite(value))
    table.fail(field.column, "expected a number, found " +
                                 (field.text.empty() ? "nothing" : quoted({field.text})));
  return value;
}

bool is_whole(float value) {
  return value == std::round(value);
}

}  // namespace

ScalarTracks read_csv_tracks(const std::string& file, std::string_view text, int frames) {
  Table table(file, text);
  const std::vector<Field> head = table.next();
  if (head.empty()) table.fail(1, "has no line of names");
  ScalarTracks tracks = tracks_of_head(table, head);
  int rows = 0;
  for (std::vector<Field> row = table.next(); !row.empty(); row = table.next()) {
    if (row.size() != head.size())
      table.fail(1, "has " + counted(std::ssize(row), "value") + " for " +
                        counted(std::ssize(head), "column"));
    if (++rows > frames) table.fail(1, "is one more than the clip's " + counted(frames, "frame"));
    for (std::size_t i = 0; i < row.size(); ++i)
      tracks[i].values.push_back(value_of(table, row[i]));
  }
  if (rows < frames)
    table.fail(1, "ends after values of " + counted(rows, "frame") + ", the clip has " +
                      std::to_string(frames));
  if (tracks.front().name == kTime) tracks.erase(tracks.begin());
  for (ScalarTrack& track : tracks) track.steps = std::ranges::all_of(track.values, is_whole);
  return tracks;
}

}  // namespace mocapress
