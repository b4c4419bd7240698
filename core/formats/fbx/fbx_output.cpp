// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_output.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::size_t kFileHead = 27;
// The file ends with an id, four zeros, zeros up to a multiple of 16, the version, 120 zeros and a
// closing id.
constexpr std::size_t kFootStart = 20;
constexpr std::size_t kFootEnd = 140;
constexpr std::size_t kFootAlignment = 16;

template <typename Number>
std::string bytes_of(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

std::string sized(char type, std::string_view bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
    throw WriteError("a text is too long for an FBX");
  return type + bytes_of(static_cast<std::uint32_t>(bytes.size())) + std::string(bytes);
}

/// Long arrays are deflated, as in other programs' files.
template <typename Number>
std::string array_of(char type, const std::vector<Number>& numbers) {
  constexpr std::size_t kShort = 128;
  constexpr int kUsualLevel = 6;
  const std::size_t size = numbers.size() * sizeof(Number);
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw WriteError("a curve is too long for an FBX");
  std::string coded(size, '\0');
  if (size > 0) std::memcpy(coded.data(), numbers.data(), size);
  const bool packs = size >= kShort;
  if (packs) {
    const std::string plain = std::move(coded);
    auto packed = compressBound(static_cast<uLong>(size));
    coded.assign(packed, '\0');
    if (compress2(reinterpret_cast<Bytef*>(coded.data()), &packed,
                  reinterpret_cast<const Bytef*>(plain.data()), static_cast<uLong>(size),
                  kUsualLevel) != Z_OK)
      throw WriteError("a curve cannot be deflated");
    coded.resize(packed);
  }
  return type + bytes_of(static_cast<std::uint32_t>(numbers.size())) +
         bytes_of(std::uint32_t{packs}) + bytes_of(static_cast<std::uint32_t>(coded.size())) +
         coded;
}

/// Writes records one after the other; nested records come between open() and close().
class Output {
 public:
  explicit Output(int version) : field_(version >= kFbxWideVersion ? 8 : 4) {}

  std::size_t head_bytes() const { return 3 * field_ + 1; }
  std::string& bytes() { return bytes_; }

  std::size_t open(std::string_view name, std::uint64_t count, std::string_view values) {
    const std::size_t at = bytes_.size();
    bytes_.append(head_bytes(), '\0');
    bytes_[at + head_bytes() - 1] = static_cast<char>(name.size());
    bytes_ += name;
    bytes_ += values;
    put(at + field_, count);
    put(at + 2 * field_, values.size());
    return at;
  }

  void close(std::size_t at, bool is_list) {
    if (is_list) bytes_.append(head_bytes(), '\0');
    put(at, bytes_.size());
  }

  /// Recursion depth is bounded: it is the depth to which the writing functions nest records.
  void add(const FbxOutRecord& record) {
    const std::size_t at = open(record.name, record.count, record.values);
    for (const FbxOutRecord& inner : record.records) add(inner);
    close(at, record.is_list || !record.records.empty() || record.count == 0);
  }

 private:
  void put(std::size_t at, std::uint64_t number) {
    if (field_ == 4 && number > std::numeric_limits<std::uint32_t>::max())
      throw WriteError("an FBX of a version before 7.5 has at most 4 GiB");
    std::memcpy(bytes_.data() + at, &number, field_);  // little-endian
  }

  std::size_t field_;
  std::string bytes_;
};

/// Copies the records of a file, applying edits.
class EditedCopy {
 public:
  EditedCopy(const FbxRecords& source, const FbxEdits& edits)
      : source_(source), edits_(edits), out_(source.version()) {}

  std::string copy() {
    out_.bytes() = source_.bytes().substr(0, kFileHead);
    std::size_t end = kFileHead;
    for (const FbxRecord* record = source_.first_child(source_.top()); record != nullptr;
         record = source_.next(*record)) {
      end = end_of(*record);
      if (end == 0) source_.fail(*record, "a record states no end: nothing is written onto it");
      add(*record);
    }
    out_.bytes().append(out_.head_bytes(), '\0');
    const std::string_view foot =
        source_.bytes().substr(std::min(end + out_.head_bytes(), source_.bytes().size()));
    const bool is_usual = foot.size() > kFootStart + kFootEnd &&
                          foot.size() <= kFootStart + kFootEnd + kFootAlignment;
    if (!is_usual) return std::move(out_.bytes()) + std::string(foot);
    out_.bytes() += foot.substr(0, kFootStart);
    out_.bytes().append(kFootAlignment - out_.bytes().size() % kFootAlignment, '\0');
    return std::move(out_.bytes()) + std::string(foot.substr(foot.size() - kFootEnd));
  }

 private:
  std::size_t end_of_values(const FbxRecord& record) const {
    return static_cast<std::size_t>(record.values.data() - source_.bytes().data()) +
           record.values.size();
  }

  /// The end offset that a record states; 0: it states none, since a record of zeros ends it.
  std::size_t end_of(const FbxRecord& record) const {
    std::uint64_t end = 0;
    std::memcpy(&end, source_.bytes().data() + record.at, (out_.head_bytes() - 1) / 3);
    return static_cast<std::size_t>(end);
  }

  /// Recursion depth is bounded: the reader limits the nesting of records.
  void add(const FbxRecord& record) {
    if (edits_.dropped.contains(&record)) return;
    if (const auto with = edits_.replaced.find(&record); with != edits_.replaced.end()) {
      out_.add(with->second);
      return;
    }
    const std::size_t at = out_.open(record.name, record.value_count, record.values);
    for (const FbxRecord* inner = source_.first_child(record); inner != nullptr;
         inner = source_.next(*inner))
      add(*inner);
    const auto more = edits_.added.find(&record);
    if (more != edits_.added.end())
      for (const FbxOutRecord& inner : more->second) out_.add(inner);
    out_.close(at, end_of(record) != end_of_values(record) || more != edits_.added.end());
  }

  const FbxRecords& source_;
  const FbxEdits& edits_;
  Output out_;
};

}  // namespace

FbxOutRecord& FbxOutRecord::value(std::int32_t number) {
  return add('I' + bytes_of(number));
}

FbxOutRecord& FbxOutRecord::value(std::int64_t number) {
  return add('L' + bytes_of(number));
}

FbxOutRecord& FbxOutRecord::value(double number) {
  return add('D' + bytes_of(number));
}

FbxOutRecord& FbxOutRecord::value(std::string_view text) {
  return add(sized('S', text));
}

FbxOutRecord& FbxOutRecord::raw(std::string_view bytes) {
  return add(sized('R', bytes));
}

FbxOutRecord& FbxOutRecord::array(const std::vector<std::int32_t>& numbers) {
  return add(array_of('i', numbers));
}

FbxOutRecord& FbxOutRecord::array(const std::vector<std::int64_t>& numbers) {
  return add(array_of('l', numbers));
}

FbxOutRecord& FbxOutRecord::array(const std::vector<float>& numbers) {
  return add(array_of('f', numbers));
}

FbxOutRecord& FbxOutRecord::array(const std::vector<double>& numbers) {
  return add(array_of('d', numbers));
}

FbxOutRecord& FbxOutRecord::record(std::string_view inner) {
  records.push_back({.name = std::string(inner)});
  return records.back();
}

FbxOutRecord& FbxOutRecord::property(std::string_view inner, std::string_view type,
                                     std::string_view label, std::string_view flags) {
  return record("P").value(inner).value(type).value(label).value(flags);
}

FbxOutRecord& FbxOutRecord::add(std::string_view bytes) {
  values += bytes;
  ++count;
  return *this;
}

std::string fbx_full_name(std::string_view name, std::string_view type) {
  return std::string(name) + std::string("\0\x01", 2) + std::string(type);
}

std::string fbx_file_bytes(int version, const std::list<FbxOutRecord>& records) {
  constexpr std::string_view kFootId(
      "\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e\0\0\0\0", kFootStart);
  constexpr std::string_view kEnd(
      "\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16);
  const std::string version_bytes = bytes_of(static_cast<std::uint32_t>(version));
  Output out(version);
  out.bytes().assign("Kaydara FBX Binary  \0\x1a\0", kFileHead - version_bytes.size());
  out.bytes() += version_bytes;
  for (const FbxOutRecord& record : records) out.add(record);
  out.bytes().append(out.head_bytes(), '\0');
  out.bytes() += kFootId;
  out.bytes().append(kFootAlignment - out.bytes().size() % kFootAlignment, '\0');
  out.bytes() += version_bytes;
  out.bytes().append(kFootEnd - version_bytes.size() - kEnd.size(), '\0');
  return std::move(out.bytes()) + std::string(kEnd);
}

std::string fbx_edited_bytes(const FbxRecords& source, const FbxEdits& edits) {
  return EditedCopy(source, edits).copy();
}

}  // namespace mocapress
