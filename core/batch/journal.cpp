// SPDX-License-Identifier: MIT
#include "core/batch/journal.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/fnv1a.h"
#include "core/base/lock_holder.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"
#include "core/mocapress/settings_json.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr int kVersion = 1;
constexpr const char* kVersionKey = "mocapress_batch";
constexpr const char* kHolderKey = "run";

std::string to_line(const JournalHeader& header) {
  return dumped({{kVersionKey, kVersion},
                 {"clips", header.clips},
                 {"list", header.list},
                 {"shard", header.shard.index},
                 {"shards", header.shard.count},
                 {kHolderKey, to_json(this_process())}});
}

/// Reads who holds the lock from a journal's first line. Unset if the line does not tell.
std::optional<LockHolder> holder_of(const fs::path& path) {
  try {
    std::string line;
    LineReader(path).next(line);
    return lock_holder_from(parse_json("", line).at(kHolderKey));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Locks the file if it is free. Reports success in any case, since the batch is being taken over.
int lock_if_free(int file) {
  lock_now(file);
  return 0;
}

AppendedFile opened(const fs::path& path, bool take_over) {
  try {
    return AppendedFile(path);
  } catch (const InUse& in_use) {
    const std::optional<LockHolder> holder = holder_of(path);
    if (!holder) throw;
    const bool is_elsewhere = holder->host != this_process().host;
    if (is_elsewhere && take_over) return AppendedFile(path, &lock_if_free);
    throw WriteError(std::string(in_use.what()) + ": " + text(*holder) +
                     (is_elsewhere ? "; if it is gone, its batch can be taken over" : ""));
  }
}

std::optional<JournalHeader> parse_header(const std::string& line) {
  try {
    const Json json = parse_json("", line);
    if (json.at(kVersionKey) != kVersion) return std::nullopt;
    return JournalHeader{json.at("clips").get<std::size_t>(),
                         json.at("list").get<std::string>(),
                         {json.at("shard").get<int>(), json.at("shards").get<int>()}};
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string first_line(const fs::path& path) {
  std::string line;
  LineReader(path).next(line);
  return line;
}

/// True if `file` is below `folder`, judged by the paths alone.
bool is_below(const std::string& file, const std::string& folder) {
  const fs::path below = utf8_path(file).lexically_relative(utf8_path(folder));
  return !below.empty() && *below.begin() != ".." && below != ".";
}

/// Called for a row whose clip is not in the batch. Throws if the clip may be missing only because
/// its folder cannot be listed now. Returns if the clip was removed from the batch.
void refuse_to_forget(const BatchRow& row, const Batch& batch) {
  for (const BatchItem item : batch.items)
    if (!item.problem.empty() && is_below(row.input, item.input))
      throw InputError(item.input, 0, 0, "cannot be listed, but holds clips that are done");
}

std::uint64_t key_of(const std::string& output) {
  Fnv1a hash;
  hash.add(output);
  return hash.state();
}

}  // namespace

JournalReader::JournalReader(const fs::path& path) : path_(utf8(path)), lines_(path) {
  std::string line;
  lines_.next(line);
  const auto header = parse_header(line);
  if (!header) throw InputError(utf8(path), 1, 0, "is not the journal of a batch");
  header_ = *header;
  std::unordered_map<std::uint64_t, Place> last;
  while (lines_.next(line))
    if (const auto row = parse_batch_row(line))
      last[key_of(row->output)] = {row->index, lines_.offset(), line.size()};
  for (const auto& [key, place] : last) places_.push_back(place);
  std::ranges::sort(places_, [](const Place& a, const Place& b) {
    return std::pair(a.index, a.offset) < std::pair(b.index, b.offset);
  });
}

void JournalReader::for_each(const std::function<void(const BatchRow&)>& visit) const {
  for (std::size_t place = 0; place < places_.size(); ++place) visit(row_at(place));
}

BatchRow JournalReader::row_at(std::size_t place) const {
  auto row = parse_batch_row(lines_.read(places_[place].offset, places_[place].length));
  if (!row) throw InputError(path_, 0, 0, "changed while it was read");
  return *std::move(row);
}

Journal::Journal(const fs::path& path, const Batch& batch, const Shard& shard, Start start,
                 bool take_over)
    : path_(path), lines_(opened(path, take_over)) {
  const JournalHeader header{batch.items.size(), fingerprint(batch), shard};
  const bool is_there = lines_.size() > 0;
  if (is_there && start == Start::New)
    throw WriteError(utf8(path_) + ": holds a batch already: it can be resumed or overwritten");
  if (is_there && start == Start::Resume)
    keep_rows_of(batch, header);
  else if (is_there)
    lines_.replace([&](StagedFile& file) { file.write(to_line(header) + '\n'); });
  else
    lines_.append(to_line(header));
}

/// Copies the rows that still belong to the batch to a new file, which replaces the old one.
void Journal::keep_rows_of(const Batch& batch, const JournalHeader& header) {
  places_.resize(batch.items.size());
  std::unordered_map<std::uint64_t, std::size_t> wanted;
  for (std::size_t i = 0; i < batch.items.size(); ++i)
    if (const BatchItem item = batch.items[i]; header.shard.has(item))
      wanted.emplace(key_of(item.output), i);
  lines_.replace([&](StagedFile& file) {
    std::uint64_t end = 0;
    const auto write = [&](const std::string& line) {
      file.write(line + '\n');
      const Place place{end, line.size()};
      end += line.size() + 1;
      return place;
    };
    write(to_line(header));
    // Only a header, perhaps cut short by a kill: there are no rows.
    if (first_line(path_).size() == lines_.size()) return;
    JournalReader(path_).for_each([&](const BatchRow& row) {
      const auto found = wanted.find(key_of(row.output));
      if (found == wanted.end()) return refuse_to_forget(row, batch);
      BatchRow moved = row;
      moved.index = found->second;
      places_[moved.index] = write(to_journal_line(moved));
    });
  });
}

std::optional<BatchRow> Journal::find(std::size_t index) const {
  const Place place = index < places_.size() ? places_[index] : Place();
  if (place.length == 0) return std::nullopt;
  return parse_batch_row(lines_.read(place.offset, place.length));
}

void Journal::append(const BatchRow& row) {
  lines_.append(to_journal_line(row));
}

}  // namespace mocapress
