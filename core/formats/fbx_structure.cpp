// SPDX-License-Identifier: MIT
#include "core/formats/fbx_structure.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/base/error.h"
#include "core/base/memory_limit.h"

namespace mocapress {
namespace {

constexpr std::size_t kDeepestRecord = 64;  // files of the usual programs have six
constexpr int kDeepestNode = 1000;
constexpr int kMostFbxNodes = 1 << 16;
constexpr std::uint64_t kBytesOfArrayByte = 3;  // inflated, parsed, and as a mesh or curve

/// Nodes by their number, and which hangs from which; 0 is the scene.
struct Structure {
  std::unordered_set<std::int64_t> nodes;
  std::unordered_multimap<std::int64_t, std::int64_t> children;
  std::unordered_map<std::int64_t, std::string> takes;  // their names
  std::unordered_set<std::int64_t> layers;
  std::unordered_set<std::int64_t> curves;
  std::size_t deepest_record = 0;
  std::uint64_t array_bytes = 0;                                // of all arrays, inflated
  std::set<std::pair<std::int64_t, std::int64_t>> connections;  // of objects
  bool is_connected_twice = false;

  /// `kind`: "OO" of two objects, "OP" of an object and a property of another.
  void connect(std::string_view kind, std::int64_t child, std::int64_t parent) {
    children.emplace(parent, child);
    if (kind == "OO") is_connected_twice |= !connections.emplace(parent, child).second;
  }
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
      add_arrays(properties, number(at + field, field), properties + property_bytes);
      at = properties + property_bytes;
      ends.push_back(end);
      found_.deepest_record = std::max(found_.deepest_record, ends.size());
    }
    return std::move(found_);
  }

 private:
  static constexpr std::size_t kVersionAt = 23;
  static constexpr std::size_t kLongestName = 1024;

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
    } else if (name == "AnimationLayer" || name == "AnimationCurve") {
      if (const auto object = id(at))
        (name == "AnimationLayer" ? found_.layers : found_.curves).insert(*object);
    } else if (name == "AnimationStack") {  // number; 'S', length, name and 0 1 "AnimStack"
      const std::size_t text_at = at + 1 + 8;
      const std::size_t length = number(text_at + 1, 4);
      if (const auto take = id(at); take && text_at + 5 <= bytes_.size())
        found_.takes[*take] =
            std::string(bytes_.substr(text_at + 5, std::min(length, kLongestName)));
    } else if (name == "C") {  // 'S', length and "OO"; child; parent
      const std::size_t length = number(at + 1, 4);
      const std::size_t child_at = at + 1 + 4 + length;
      const auto child = id(child_at);
      const auto parent = id(child_at + 1 + 8);
      if (child && parent) found_.connect(bytes_.substr(at + 5, length), *child, *parent);
    }
  }
  /// What the arrays among a record's properties inflate to: a type, then for arrays u32 count, u32
  /// encoding and u32 bytes, for texts u32 bytes.
  void add_arrays(std::size_t at, std::size_t count, std::size_t end) {
    for (; count > 0 && at < end; --count) {
      const char type = bytes_[at++];
      const std::size_t wide = type == 'd' || type == 'l' ? 8 : type == 'b' ? 1 : 4;
      if (std::string_view("fdlib").find(type) != std::string_view::npos) {
        found_.array_bytes += number(at, 4) * wide;
        at += 12 + number(at + 8, 4);
      } else if (type == 'S' || type == 'R') {
        at += 4 + number(at, 4);
      } else {
        at += type == 'C' || type == 'B' ? 1 : type == 'Y' ? 2 : type == 'I' || type == 'F' ? 4 : 8;
      }
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
      if (before[0] == "AnimationLayer:") found.layers.insert(*number);
      if (before[0] == "AnimationCurve:") found.curves.insert(*number);
      const auto child = id(before[0]);
      if (before[2] == "C:" && child)
        found.connect(before[1] == "\"OO\"" ? "OO" : "OP", *child, *number);
    }
    if (const auto take = id(before[0]); take && before[1] == "AnimationStack:")
      found.takes[*take] = std::string(word);
    before = {word, before[0], before[1]};
  }
  return found;
}

Structure structure_of(std::string_view bytes) {
  return bytes.starts_with("Kaydara FBX Binary") ? BinaryRecords(bytes).read()
                                                 : ascii_structure(bytes);
}

/// "AnimStack::walk" of ASCII in its quotes, "walk" 0 1 "AnimStack" of binary files: walk.
std::string take_name(std::string name) {
  std::erase(name, '"');
  if (const std::size_t colons = name.find("::"); colons != name.npos) name.erase(0, colons + 2);
  return name.substr(0, name.find('\0'));
}

}  // namespace

std::vector<std::string> layered_fbx_takes(std::string_view bytes) {
  const Structure structure = structure_of(bytes);
  const auto& children = structure.children;
  const auto is_moved = [&](std::int64_t curve_node) {
    const auto [first, end] = children.equal_range(curve_node);
    return std::any_of(first, end,
                       [&](const auto& child) { return structure.curves.contains(child.second); });
  };
  std::unordered_multimap<std::int64_t, std::int64_t> layers_of;  // of curve nodes with curves
  std::vector<std::string> layered;
  for (const std::int64_t layer : structure.layers) {
    const auto [first, end] = children.equal_range(layer);
    for (auto child = first; child != end; ++child)
      if (is_moved(child->second)) layers_of.emplace(child->second, layer);
  }
  std::unordered_map<std::int64_t, std::vector<std::int64_t>> layers_that_move;  // each node
  for (const auto& [parent, child] : children) {
    if (!structure.nodes.contains(parent)) continue;
    const auto [first, end] = layers_of.equal_range(child);
    for (auto layer = first; layer != end; ++layer)
      layers_that_move[parent].push_back(layer->second);
  }
  for (const auto& [take, name] : structure.takes) {
    std::unordered_set<std::int64_t> own;
    const auto [first, end] = children.equal_range(take);
    for (auto child = first; child != end; ++child)
      if (structure.layers.contains(child->second)) own.insert(child->second);
    if (own.size() < 2) continue;
    const bool twice = std::any_of(layers_that_move.begin(), layers_that_move.end(),
                                   [&](const auto& node_and_layers) {
                                     std::unordered_set<std::int64_t> moving;
                                     for (const std::int64_t layer : node_and_layers.second)
                                       if (own.contains(layer)) moving.insert(layer);
                                     return moving.size() > 1;
                                   });
    if (twice) layered.push_back(take_name(name));
  }
  return layered;
}

void check_fbx_structure(const std::string& file, std::string_view bytes) {
  const auto refuse = [&](const std::string& what) { throw InputError(file, 0, 0, what); };
  const Structure structure = structure_of(bytes);
  if (structure.deepest_record > kDeepestRecord)
    refuse("nests records deeper than " + std::to_string(kDeepestRecord));
  if (structure.is_connected_twice) refuse("connects the same two objects twice");
  require_memory(file, kBytesOfArrayByte * structure.array_bytes);
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
    if (visits == kMostFbxNodes)
      refuse("has more than " + std::to_string(kMostFbxNodes) + " nodes");
    const auto [first, end] = structure.children.equal_range(visit.node);
    for (auto child = first; child != end; ++child)
      if (structure.nodes.contains(child->second)) open.push_back({child->second, visit.depth + 1});
  }
}

}  // namespace mocapress
