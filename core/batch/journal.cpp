// SPDX-License-Identifier: MIT
#include "core/batch/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/fnv1a.h"
#include "core/batch/preset_json.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr const char* kVersionKey = "mocapress_batch";

std::string to_line(const JournalHeader& header) {
  return dumped({{kVersionKey, kVersion},
                 {"clips", header.clips},
                 {"list", header.list},
                 {"shard", header.shard.index},
                 {"shards", header.shard.count}});
}

std::optional<JournalHeader> parse_header(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    if (json.at(kVersionKey) != kVersion) return std::nullopt;
    return JournalHeader{json.at("clips").get<std::size_t>(),
                         json.at("list").get<std::string>(),
                         {json.at("shard").get<int>(), json.at("shards").get<int>()}};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::uint64_t key_of(const std::string& output) {
  Fnv1a hash;
  hash.add(output);
  return hash.state();
}

/// Everything, however often the system takes only a part. False: errno says why.
bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

JournalReader::JournalReader(const fs::path& path) : stream_(path, std::ios::binary) {
  if (!stream_) throw InputError(path.string(), 0, 0, std::strerror(errno));
  std::string line;
  std::getline(stream_, line);
  const auto header = parse_header(line);
  if (!header) throw InputError(path.string(), 1, 0, "is not the journal of a batch");
  header_ = *header;
  std::unordered_map<std::uint64_t, Place> last;
  for (std::streamoff offset = stream_.tellg(); std::getline(stream_, line);
       offset += static_cast<std::streamoff>(line.size()) + 1)
    if (const auto row = parse_batch_row(line)) last[key_of(row->output)] = {row->index, offset};
  for (const auto& [key, place] : last) places_.push_back(place);
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return std::pair(a.index, a.offset) < std::pair(b.index, b.offset);
  });
}

void JournalReader::for_each(const std::function<void(const BatchRow&)>& visit) {
  for (std::size_t place = 0; place < places_.size(); ++place)
    if (const auto row = row_at(place)) visit(*row);
}

std::optional<BatchRow> JournalReader::row_at(std::size_t place) {
  stream_.clear();
  stream_.seekg(places_[place].offset);
  std::string line;
  std::getline(stream_, line);
  return parse_batch_row(line);
}

Journal::Journal(const fs::path& path, const Batch& batch, const Shard& shard, Start start)
    : path_(path) {
  const JournalHeader header{batch.items.size(), fingerprint(batch), shard};
  std::error_code none;
  const std::uintmax_t size = fs::file_size(path_, none);
  const bool is_there = !none && size > 0;
  if (is_there && start == Start::New)
    fail("holds a batch already: it can be resumed, or overwritten");
  try {
    open(true);
    if (is_there && start == Start::Resume) {
      keep_rows_of(batch, header);
      return;
    }
    if (::ftruncate(file_, 0) != 0) fail(std::strerror(errno));
    write_line(to_line(header));
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

void Journal::open(bool create) {
  const int file =
      ::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | (create ? O_CREAT : 0), 0666);
  if (file < 0) fail(std::strerror(errno));
  if (file_ >= 0) ::close(file_);
  file_ = file;
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    fail("another run is at work on this batch");
}

/// Copies what counts to a new file, which takes the old one's place.
void Journal::keep_rows_of(const Batch& batch, const JournalHeader& header) {
  places_.resize(batch.items.size());
  std::unordered_map<std::uint64_t, std::size_t> wanted;
  for (std::size_t i = 0; i < batch.items.size(); ++i)
    if (const BatchItem item = batch.items[i]; header.shard.has(item))
      wanted.emplace(key_of(item.output), i);
  const fs::path target = std::exchange(path_, fs::path(path_) += ".part");
  const int locked = std::exchange(file_, -1);  // until the new file is in place and locked too
  try {
    std::error_code ignored;
    fs::remove(path_, ignored);
    open(true);
    write_line(to_line(header));
    try {
      JournalReader(target).for_each([&](const BatchRow& row) {
        const auto found = wanted.find(key_of(row.output));
        if (found == wanted.end()) return;
        BatchRow moved = row;
        moved.index = found->second;
        const std::uint64_t begin = end_;
        append(moved);
        places_[moved.index] = {begin, static_cast<std::size_t>(end_ - begin - 1)};
      });
    } catch (const InputError&) {  // no header: nothing of it counts
    }
    fs::rename(path_, target);
  } catch (const fs::filesystem_error& error) {
    ::close(locked);
    fail(error.code().message());
  } catch (...) {
    ::close(locked);
    throw;
  }
  ::close(locked);
  path_ = target;
}

std::optional<BatchRow> Journal::find(std::size_t index) const {
  const Place place = index < places_.size() ? places_[index] : Place();
  if (place.length == 0) return std::nullopt;
  std::string line(place.length, '\0');
  const ssize_t got = ::pread(file_, line.data(), line.size(), static_cast<off_t>(place.offset));
  if (got != static_cast<ssize_t>(line.size())) return std::nullopt;
  return parse_batch_row(line);
}

void Journal::append(const BatchRow& row) {
  write_line(to_journal_line(row));
}

void Journal::write_line(const std::string& line) {
  if (!write_all(file_, line + '\n')) fail(std::strerror(errno));
  end_ += line.size() + 1;
}

void Journal::fail(const std::string& why) const {
  throw WriteError(path_.string() + ": " + why);
}

}  // namespace mocapress
