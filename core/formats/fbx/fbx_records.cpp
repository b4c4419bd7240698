// SPDX-License-Identifier: MIT
// Binary: a header of 27 bytes, then records. A record is its end offset, its number of values and
// their size in bytes (u32 each, from version 7.5 on u64), the length of its name (u8), the name,
// the values, and its nested records, which a record of zeros ends. A value is a letter for its
// type, then its bytes. An array is its number of elements, whether zlib compressed it, its number
// of bytes (u32 each), then the bytes. ASCII: `Name: value, value { records }`.
#include "core/formats/fbx/fbx_records.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/base/error.h"
#include "core/base/memory_limit.h"
#include "core/formats/text_cursor.h"

namespace mocapress {
namespace {

constexpr std::string_view kBinaryMagic = "Kaydara FBX Binary";
constexpr std::size_t kEndianAt = 22;
constexpr std::size_t kVersionAt = 23;
constexpr std::size_t kHeadBytes = 27;
constexpr int kOldestVersion = 6000;
constexpr std::size_t kDeepestRecord = 64;  // usual files have eight levels
constexpr std::size_t kMostRecords = 4'000'000;
constexpr std::size_t kArrayHead = 13;
constexpr std::size_t kMostDeflateRatio = 1040;

/// The size in bytes of a fixed-size value or of an array's element, by its type; 0 for other
/// types.
std::size_t bytes_of_type(char type) {
  switch (type) {
    case 'C':
    case 'B':
    case 'c':
    case 'b':
      return 1;
    case 'Y':
      return 2;
    case 'I':
    case 'F':
    case 'i':
    case 'f':
      return 4;
    case 'L':
    case 'D':
    case 'l':
    case 'd':
      return 8;
    default:
      return 0;
  }
}

bool is_array(char type) {
  return std::string_view("cbilfd").find(type) != std::string_view::npos;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Skips blanks, commas and comments between values.
std::size_t skip_between(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (text[at] == ';') {
      at = std::min(text.find('\n', at), text.size());
    } else if (is_blank(text[at]) || text[at] == ',') {
      ++at;
    } else {
      break;
    }
  }
  return at;
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
  while (at < text.size() && !is_blank(text[at]) &&
         std::string_view(",;\"{}:").find(text[at]) == std::string_view::npos)
    ++at;
  return at;
}

FbxValue value_of_word(std::string_view word) {
  FbxValue value;
  const char* const end = word.data() + word.size();
  if (std::from_chars(word.data(), end, value.integer).ptr == end) return value;
  if (const auto real = parse_number(word)) {
    value.kind = FbxValue::Kind::Real;
    value.real = *real;
    return value;
  }
  value.kind = FbxValue::Kind::Text;
  value.text = word;
  return value;
}

}  // namespace

double FbxValue::number() const {
  if (kind == Kind::Integer) return static_cast<double>(integer);
  return kind == Kind::Real ? real : std::numeric_limits<double>::quiet_NaN();
}

std::int64_t FbxValue::whole() const {
  if (kind == Kind::Integer) return integer;
  constexpr double kLargest = 9e18;
  return kind == Kind::Real && std::abs(real) <= kLargest ? std::llround(real) : 0;
}

char FbxValue::letter() const {
  if (kind == Kind::Integer && integer > 0 && integer < 128) return static_cast<char>(integer);
  return kind == Kind::Text && text.size() == 1 ? text.front() : '\0';
}

/// Walks the bytes of a binary file without recursion.
class FbxRecords::BinaryScan {
 public:
  explicit BinaryScan(FbxRecords& into)
      : into_(into), bytes_(into.bytes_), field_(into.version_ >= kFbxWideVersion ? 8 : 4) {}

  void scan() {
    std::size_t at = kHeadBytes;
    open_.push_back({0, 0, 0});
    for (;;) {
      const Open& parent = open_.back();
      const bool is_full = parent.end > 0 && at >= parent.end;
      if (is_full && at > parent.end) into_.fail_at(at, "a record reaches beyond its parent");
      if (is_full) {
        open_.pop_back();
        continue;
      }
      const std::size_t head = 3 * field_ + 1;
      if (bytes_.size() - at < head) into_.fail_at(at, "ends within a record");
      const std::uint64_t end = field(at);
      const auto name_bytes = static_cast<std::uint8_t>(bytes_[at + head - 1]);
      if (end == 0 && name_bytes == 0) {  // a record of zeros ends the parent's list
        at += head;
        if (open_.size() == 1) return;
        if (parent.end > 0 && at != parent.end)
          into_.fail_at(at, "a record ends before the place it states");
        open_.pop_back();
        continue;
      }
      at = scan_record(at, end, head, name_bytes);
    }
  }

 private:
  struct Open {
    std::uint32_t record;
    std::size_t end;           // 0: ended by a record of zeros
    std::uint32_t last_child;  // 0: none yet
  };

  std::uint64_t field(std::size_t at) const {
    return field_ == 8 ? into_.number_at<std::uint64_t>(bytes_, at)
                       : into_.number_at<std::uint32_t>(bytes_, at);
  }

  /// Scans a record's head and returns the start of its nested records.
  std::size_t scan_record(std::size_t at, std::uint64_t end, std::size_t head,
                          std::size_t name_bytes) {
    const std::size_t limit = open_.back().end > 0 ? open_.back().end : bytes_.size();
    const std::uint64_t count = field(at + field_);
    const std::uint64_t value_bytes = field(at + 2 * field_);
    const std::size_t names = at + head;
    if (end > limit) into_.fail_at(at, "a record reaches beyond its parent");
    const std::size_t room = end > 0 ? end : limit;
    if (names > room || name_bytes > room - names) into_.fail_at(at, "ends within a record");
    const std::size_t values = names + name_bytes;
    if (value_bytes > room - values) into_.fail_at(at, "a record is smaller than its values");
    if (count > value_bytes) into_.fail_at(at, "a record has too few bytes for its values");
    const FbxRecord record{.name = bytes_.substr(names, name_bytes),
                           .values = bytes_.substr(values, value_bytes),
                           .value_count = count,
                           .at = at};
    check_values(record);
    if (open_.size() > kDeepestRecord)
      into_.fail("nests records deeper than " + std::to_string(kDeepestRecord));
    const std::uint32_t index = into_.add(record);
    Open& parent = open_.back();
    (parent.last_child > 0 ? into_.records_[parent.last_child].next
                           : into_.records_[parent.record].first_child) = index;
    parent.last_child = index;
    const std::size_t after = values + value_bytes;
    if (end == 0 || after < end) open_.push_back({index, end, 0});
    return after;
  }

  void check_values(const FbxRecord& record) const {
    std::size_t at = 0;
    const std::string_view all = record.values;
    const auto at_file = [&] { return static_cast<std::size_t>(all.data() - bytes_.data()) + at; };
    for (std::size_t i = 0; i < record.value_count; ++i) {
      if (at >= all.size()) into_.fail_at(at_file(), "ends within a value");
      const char type = all[at];
      std::uint64_t size = 1 + bytes_of_type(type);
      if (type == 'S' || type == 'R') {
        if (all.size() - at < 5) into_.fail_at(at_file(), "ends within a value");
        size = 5 + std::uint64_t{into_.number_at<std::uint32_t>(all, at + 1)};
      } else if (is_array(type)) {
        if (all.size() - at < kArrayHead) into_.fail_at(at_file(), "ends within an array");
        size = kArrayHead + std::uint64_t{into_.number_at<std::uint32_t>(all, at + 9)};
      } else if (size == 1) {
        into_.fail_at(at_file(), "has a value of an unknown type");
      }
      if (size > all.size() - at) into_.fail_at(at_file(), "a value reaches beyond its record");
      at += size;
    }
  }

  FbxRecords& into_;
  std::string_view bytes_;
  std::size_t field_;
  std::vector<Open> open_;
};

/// Walks the text of an ASCII file.
class FbxRecords::AsciiScan {
 public:
  explicit AsciiScan(FbxRecords& into) : into_(into), text_(into.bytes_) {}

  void scan() {
    open_.push_back({0, 0});
    std::size_t at = 0;
    while (at < text_.size()) {
      const char c = text_[at];
      if (c == '\n') ++line_;
      if (c == ',' || is_blank(c)) {
        ++at;
      } else if (c == ';') {
        at = std::min(text_.find('\n', at), text_.size());
      } else if (c == '"') {
        const std::size_t end = text_.find('"', at + 1);
        if (end == text_.npos) into_.fail_at(line_, "ends within a text");
        line_ += static_cast<std::size_t>(
            std::count(text_.begin() + static_cast<std::ptrdiff_t>(at),
                       text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        at = end + 1;
        expect_values(at);
      } else if (c == '{') {
        open_record();
        ++at;
      } else if (c == '}') {
        close_record();
        ++at;
      } else {
        const std::size_t end = end_of_word(text_, at);
        if (end < text_.size() && text_[end] == ':') {
          begin_record(at, end);
          at = end + 1;
        } else {
          at = std::max(end, at + 1);
          expect_values(at);
        }
      }
    }
    end_values();
    if (open_.size() > 1) into_.fail_at(line_, "ends within a record");
  }

 private:
  struct Open {
    std::uint32_t record;
    std::uint32_t last_child;  // 0: none yet
  };

  void begin_record(std::size_t name, std::size_t colon) {
    end_values();
    current_ = into_.add({.name = text_.substr(name, colon - name), .at = line_});
    Open& parent = open_.back();
    (parent.last_child > 0 ? into_.records_[parent.last_child].next
                           : into_.records_[parent.record].first_child) = current_;
    parent.last_child = current_;
    values_at_ = colon + 1;
    after_values_ = colon + 1;
  }

  void expect_values(std::size_t after) {
    if (current_ == 0) into_.fail_at(line_, "has a value outside of records");
    after_values_ = after;
  }

  void end_values() {
    if (current_ > 0)
      into_.records_[current_].values = text_.substr(values_at_, after_values_ - values_at_);
  }

  void open_record() {
    if (open_.size() > kDeepestRecord)
      into_.fail("nests records deeper than " + std::to_string(kDeepestRecord));
    if (current_ == 0) into_.fail_at(line_, "opens a record without a name");
    end_values();
    open_.push_back({current_, 0});
    current_ = 0;
  }

  void close_record() {
    end_values();
    current_ = 0;
    if (open_.size() == 1) into_.fail_at(line_, "closes a record that is not open");
    open_.pop_back();
  }

  FbxRecords& into_;
  std::string_view text_;
  std::size_t line_ = 1;
  std::vector<Open> open_;
  std::uint32_t current_ = 0;  // the record whose values are read; 0: none
  std::size_t values_at_ = 0;
  std::size_t after_values_ = 0;
};

FbxRecords::FbxRecords(const std::string& file, std::string_view bytes)
    : file_(file), bytes_(bytes) {
  records_.push_back({});
  is_binary_ = bytes.starts_with(kBinaryMagic);
  const auto refuse_old = [&] {
    if (version_ < kOldestVersion)
      fail("is FBX " + std::to_string(version_ / 1000) + '.' + std::to_string(version_ / 100 % 10) +
           ": versions from 6.0 on are read");
  };
  if (is_binary_) {
    if (bytes.size() < kHeadBytes) fail("ends within its head");
    is_big_endian_ = bytes[kEndianAt] == 1;
    version_ = static_cast<int>(
        std::min(number_at<std::uint32_t>(bytes, kVersionAt), std::uint32_t{99'999}));
    refuse_old();
    BinaryScan(*this).scan();
    return;
  }
  constexpr std::size_t kStart = 4096;
  const std::string_view start = bytes.substr(0, kStart);
  if (start.find("FBX") == start.npos)
    fail("cannot be read as FBX: it begins neither like a binary file nor like an ASCII one");
  AsciiScan(*this).scan();
  if (const FbxRecord* const head = find(top(), "FBXHeaderExtension"))
    if (const FbxRecord* const version = find(*head, "FBXVersion"))
      if (const auto stated = value(*version, 0))
        version_ = static_cast<int>(std::clamp<std::int64_t>(stated->whole(), 0, 99'999));
  if (version_ == 0) {  // the head: "; FBX 5.8.0 project file"
    const std::size_t at = start.find("; FBX ");
    if (at != start.npos && at + 8 < start.size())
      version_ = 1000 * (start[at + 6] - '0') + 100 * (start[at + 8] - '0');
  }
  if (version_ == 0) fail("cannot be read as FBX: it states no version");
  refuse_old();
}

const FbxRecord* FbxRecords::first_child(const FbxRecord& record) const {
  return record.first_child > 0 ? &records_[record.first_child] : nullptr;
}

const FbxRecord* FbxRecords::next(const FbxRecord& record) const {
  return record.next > 0 ? &records_[record.next] : nullptr;
}

const FbxRecord* FbxRecords::find(const FbxRecord& in, std::string_view name) const {
  const FbxRecord* child = first_child(in);
  while (child != nullptr && child->name != name) child = next(*child);
  return child;
}

std::vector<FbxValue> FbxRecords::values(const FbxRecord& record) const {
  std::vector<FbxValue> values;
  const std::string_view all = record.values;
  if (!is_binary_) {
    for (std::size_t at = skip_between(all, 0); at < all.size(); at = skip_between(all, at)) {
      if (all[at] == '"') {
        const std::size_t end = std::min(all.find('"', at + 1), all.size());
        values.push_back({.kind = FbxValue::Kind::Text, .text = all.substr(at + 1, end - at - 1)});
        at = std::min(end + 1, all.size());
      } else {
        const std::size_t end = std::max(end_of_word(all, at), at + 1);
        values.push_back(value_of_word(all.substr(at, end - at)));
        at = end;
      }
    }
    return values;
  }
  values.reserve(record.value_count);
  std::size_t at = 0;
  for (std::size_t i = 0; i < record.value_count; ++i) {
    const char type = all[at];
    FbxValue value;
    std::size_t size = 1 + bytes_of_type(type);
    if (type == 'S' || type == 'R') {
      const auto length = number_at<std::uint32_t>(all, at + 1);
      size = 5 + std::size_t{length};
      value.kind = FbxValue::Kind::Text;
      value.text = all.substr(at + 5, length);
    } else if (is_array(type)) {
      size = kArrayHead + number_at<std::uint32_t>(all, at + 9);
      value.kind = FbxValue::Kind::Array;
      value.text = all.substr(at, size);
    } else if (type == 'F' || type == 'D') {
      value.kind = FbxValue::Kind::Real;
      value.real = type == 'D' ? number_at<double>(all, at + 1)
                               : static_cast<double>(number_at<float>(all, at + 1));
    } else {
      value.integer = size == 2   ? static_cast<unsigned char>(all[at + 1])
                      : size == 3 ? number_at<std::int16_t>(all, at + 1)
                      : size == 5 ? number_at<std::int32_t>(all, at + 1)
                                  : number_at<std::int64_t>(all, at + 1);
    }
    values.push_back(value);
    at += size;
  }
  return values;
}

std::optional<FbxValue> FbxRecords::value(const FbxRecord& record, std::size_t index) const {
  const std::vector<FbxValue> all = values(record);
  return index < all.size() ? std::optional(all[index]) : std::nullopt;
}

std::string FbxRecords::text(const FbxRecord& in, std::string_view name) const {
  const FbxRecord* const record = find(in, name);
  const auto stated = record != nullptr ? value(*record, 0) : std::nullopt;
  return stated && stated->kind == FbxValue::Kind::Text ? std::string(stated->text) : std::string();
}

template <typename Number, typename Convert>
std::vector<Number> FbxRecords::collected(const FbxRecord& record, const Convert& convert) {
  const FbxRecord* of = &record;
  if (!is_binary_)  // ASCII arrays: Name: *3 { a: 1,2,3 }
    if (const FbxRecord* const inner = find(record, "a")) of = inner;
  std::vector<Number> numbers;
  for (const FbxValue& value : values(*of)) {
    if (value.kind != FbxValue::Kind::Array) {
      if (value.kind != FbxValue::Kind::Text || !value.text.starts_with('*'))
        numbers.push_back(convert(value));
      continue;
    }
    std::size_t count = 0;
    const std::string elements = unpacked(record, value.text, count);
    numbers.reserve(numbers.size() + count);
    const auto append = [&](auto zero) {
      using Stored = decltype(zero);
      constexpr bool is_real = std::is_floating_point_v<Stored>;
      FbxValue element{.kind = is_real ? FbxValue::Kind::Real : FbxValue::Kind::Integer};
      for (std::size_t i = 0; i < count; ++i) {
        const auto number = number_at<Stored>(elements, i * sizeof(Stored));
        if constexpr (is_real)
          element.real = static_cast<double>(number);
        else
          element.integer = number;
        numbers.push_back(convert(element));
      }
    };
    switch (value.text.front()) {
      case 'f':
        append(float{});
        break;
      case 'd':
        append(double{});
        break;
      case 'i':
        append(std::int32_t{});
        break;
      case 'l':
        append(std::int64_t{});
        break;
      default:
        append(std::uint8_t{});
    }
  }
  return numbers;
}

std::vector<double> FbxRecords::numbers(const FbxRecord& record) {
  return collected<double>(record, [](const FbxValue& value) { return value.number(); });
}

std::vector<std::int64_t> FbxRecords::integers(const FbxRecord& record) {
  return collected<std::int64_t>(record, [](const FbxValue& value) { return value.whole(); });
}

std::vector<std::uint32_t> FbxRecords::float_bits(const FbxRecord& record) {
  constexpr int kTextHasBits = 7200;  // ASCII from this version on states the bits as an integer
  const bool is_bits = !is_binary_ && version_ >= kTextHasBits;
  return collected<std::uint32_t>(record, [&](const FbxValue& value) {
    return value.kind == FbxValue::Kind::Integer && (is_bits || is_binary_)
               ? static_cast<std::uint32_t>(value.integer)
               : std::bit_cast<std::uint32_t>(static_cast<float>(value.number()));
  });
}

std::vector<double> FbxRecords::numbers(const FbxRecord& in, std::string_view name) {
  const FbxRecord* const record = find(in, name);
  return record != nullptr ? numbers(*record) : std::vector<double>();
}

std::vector<std::int64_t> FbxRecords::integers(const FbxRecord& in, std::string_view name) {
  const FbxRecord* const record = find(in, name);
  return record != nullptr ? integers(*record) : std::vector<std::int64_t>();
}

void FbxRecords::fail(const FbxRecord& at, const std::string& message) const {
  fail_at(at.at, message);
}

void FbxRecords::fail(const std::string& message) const {
  throw InputError(file_, 0, 0, message);
}

void FbxRecords::fail_at(std::size_t at, const std::string& message) const {
  fail(message + (is_binary_ ? " (byte " : " (line ") + std::to_string(at) + ')');
}

std::uint32_t FbxRecords::add(const FbxRecord& record) {
  if (records_.size() == kMostRecords)
    fail("has more than " + std::to_string(kMostRecords) + " records");
  records_.push_back(record);
  return static_cast<std::uint32_t>(records_.size() - 1);
}

template <typename Number>
Number FbxRecords::number_at(std::string_view bytes, std::size_t at) const {
  char raw[sizeof(Number)];
  std::memcpy(raw, bytes.data() + at, sizeof raw);
  if (is_big_endian_) std::reverse(raw, raw + sizeof raw);
  Number number;
  std::memcpy(&number, raw, sizeof number);
  return number;
}

std::string FbxRecords::unpacked(const FbxRecord& record, std::string_view array,
                                 std::size_t& count) {
  count = number_at<std::uint32_t>(array, 1);
  const auto encoding = number_at<std::uint32_t>(array, 5);
  const std::string_view coded = array.substr(kArrayHead);
  const std::size_t bytes = count * bytes_of_type(array.front());
  if (encoding > 1) fail(record, "has an array of an unknown encoding");
  if (encoding == 0 && coded.size() < bytes)
    fail(record, "an array has fewer values than it states");
  if (encoding == 0) return std::string(coded.substr(0, bytes));
  if (bytes / kMostDeflateRatio > coded.size())
    fail(record, "an array states more values than its bytes can hold");
  unpacked_bytes_ += bytes;
  require_memory(file_, unpacked_bytes_);
  std::string plain(bytes, '\0');
  auto size = static_cast<uLongf>(bytes);
  const int result =
      uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                 reinterpret_cast<const Bytef*>(coded.data()), static_cast<uLong>(coded.size()));
  if (result != Z_OK || size != bytes) fail(record, "has an array that cannot be unpacked");
  return plain;
}

FbxName fbx_name(std::string_view text) {
  constexpr std::string_view kBinaryColons("\0\x01", 2);
  if (const std::size_t at = text.find(kBinaryColons); at != text.npos)
    return {std::string(text.substr(0, at)), std::string(text.substr(at + 2))};
  if (const std::size_t at = text.find("::"); at != text.npos)
    return {std::string(text.substr(at + 2)), std::string(text.substr(0, at))};
  return {std::string(text), {}};
}

}  // namespace mocapress
