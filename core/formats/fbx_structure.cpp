// SPDX-License-Identifier: MIT
#include "core/formats/fbx_structure.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::size_t kDeepestRecord = 64;  // files of the usual programs have six
constexpr int kDeepestNode = 1000;
constexpr int kMostNodes = 1 << 16;

/// Nodes by their number, and which hangs from which; 0 is the scene.
struct Structure {
  std::unordered_set<std::int64_t> nodes;
  std::unordered_multimap<std::int64_t, std::int64_t> children;
  std::size_t deepest_record = 0;
};

/// Records of a head, properties and records:
///   end of the record, number of properties, their bytes (u32 each, from version 7500 on u64),
///   u8 length of the name, name, properties, records, a record of zeros.
class BinaryRecords {
 public:
  explicit BinaryRecords(std::string_view bytes) : bytes_(bytes) {}

  Structure read() {
    std::uint32_t version = 0;
    take(kVersionAt, version);
    const std::size_t field = version >= 7500 ? 8 : 4;
    std::vector<std::size_t> ends;  // of the records that are open
    std::size_t at = kVersionAt + sizeof version;
    while (at < bytes_.size() && ends.size() <= kDeepestRecord) {
      if (!ends.empty() && at >= ends.back()) {
        at = ends.back();
        ends.pop_back();
        continue;
      }
      const std::size_t end = number(at, field);
      const std::size_t property_bytes = number(at + 2 * field, field);
      std::uint8_t name_bytes = 0;
      const std::size_t head = at + 3 * field + 1;
      if (!take(head - 1, name_bytes)) break;
      if (end == 0) {  // the last of its parent
        if (ends.empty()) break;
        at = ends.back();
        ends.pop_back();
        continue;
      }
      const std::size_t properties = head + name_bytes;
      if (end < properties || end > bytes_.size() || property_bytes > end - properties) break;
      note(bytes_.substr(head, name_bytes), properties);
      at = properties + property_bytes;
      ends.push_back(end);
      found_.deepest_record = std::max(found_.deepest_record, ends.size());
    }
    return std::move(found_);
  }

 private:
  static constexpr std::size_t kVersionAt = 23;

  template <typename Number>
  bool take(std::size_t at, Number& value) const {
    if (at > bytes_.size() || bytes_.size() - at < sizeof value) return false;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return true;
  }
  std::size_t number(std::size_t at, std::size_t bytes) const {
    std::uint64_t wide = 0;
    std::uint32_t narrow = 0;
    if (bytes == sizeof wide) return take(at, wide) ? wide : 0;
    return take(at, narrow) ? narrow : 0;
  }
  /// A property of 64 bits: 'L' and the number.
  std::optional<std::int64_t> id(std::size_t at) const {
    std::int64_t value = 0;
    if (at >= bytes_.size() || bytes_[at] != 'L' || !take(at + 1, value)) return std::nullopt;
    return value;
  }
  void note(std::string_view name, std::size_t at) {
    if (name == "Model") {
      if (const auto node = id(at)) found_.nodes.insert(*node);
    } else if (name == "C") {  // 'S', length and "OO"; child; parent
      const std::size_t child_at = at + 1 + 4 + number(at + 1, 4);
      const auto child = id(child_at);
      const auto parent = id(child_at + 1 + 8);
      if (child && parent) found_.children.emplace(*parent, *child);
    }
  }

  std::string_view bytes_;
  Structure found_;
};

/// Of the words of ASCII FBX: Model: id, ... and C: "OO", child, parent.
Structure ascii_structure(std::string_view text) {
  constexpr std::string_view kBetween = " \t\r\n,";
  Structure found;
  std::size_t depth = 0;
  std::array<std::string_view, 3> before;  // the last words, the nearest first
  const auto id = [](std::string_view word) {
    std::int64_t value = 0;
    const auto end = word.data() + word.size();
    return std::from_chars(word.data(), end, value).ptr == end ? std::optional(value)
                                                               : std::nullopt;
  };
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    std::size_t end = at + 1;
    if (c == ';') {
      end = text.find('\n', at);
    } else if (c == '"') {
      end = std::min(text.find('"', at + 1), text.size() - 1) + 1;
    } else if (c == '{') {
      found.deepest_record = std::max(found.deepest_record, ++depth);
    } else if (c == '}') {
      depth -= depth > 0;
    } else if (kBetween.find(c) == kBetween.npos && c != ':') {
      end = text.find_first_of(" \t\r\n,;\"{}:", at);
      if (end < text.size() && text[end] == ':') ++end;
    }
    const std::string_view word = text.substr(at, end - at);
    at = std::min(end, text.size());
    if (kBetween.find(c) != kBetween.npos || c == ';') continue;
    if (const auto number = id(word)) {
      if (before[0] == "Model:") found.nodes.insert(*number);
      const auto child = id(before[0]);
      if (before[2] == "C:" && child) found.children.emplace(*number, *child);
    }
    before = {word, before[0], before[1]};
  }
  return found;
}

}  // namespace

void check_fbx_structure(const std::string& file, std::string_view bytes) {
  const auto refuse = [&](const std::string& what) { throw InputError(file, 0, 0, what); };
  const Structure structure = bytes.starts_with("Kaydara FBX Binary") ? BinaryRecords(bytes).read()
                                                                      : ascii_structure(bytes);
  if (structure.deepest_record > kDeepestRecord)
    refuse("nests records deeper than " + std::to_string(kDeepestRecord));
  struct Visit {
    std::int64_t node;
    int depth;
  };
  std::vector<Visit> open = {{0, 0}};
  for (int visits = 0; !open.empty(); ++visits) {
    const Visit visit = open.back();
    open.pop_back();
    if (visit.depth > kDeepestNode)
      refuse("its nodes hang in a circle, or deeper than " + std::to_string(kDeepestNode));
    if (visits == kMostNodes) refuse("has more than " + std::to_string(kMostNodes) + " nodes");
    const auto [first, end] = structure.children.equal_range(visit.node);
    for (auto child = first; child != end; ++child)
      if (structure.nodes.contains(child->second)) open.push_back({child->second, visit.depth + 1});
  }
}

}  // namespace mocapress
