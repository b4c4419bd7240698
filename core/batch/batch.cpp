// SPDX-License-Identifier: MIT
#include "core/batch/batch.h"

#include <charconv>
#include <unordered_map>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/fnv1a.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kFormatNames = {"mcpr", "bvh", "amc", "csv"};

/// "walks/slow" for walks/slow/a.bvh found by "../walks" or by "." in walks.
std::string folder_of(const fs::path& input, const fs::path& clip) {
  std::error_code error;
  if (!fs::is_directory(input, error)) return "";
  fs::path folder = fs::weakly_canonical(input, error);
  if (!folder.has_filename()) folder = folder.parent_path();  // of "walks/"
  const fs::path below = clip.lexically_relative(input).parent_path();
  return (below.empty() ? folder.filename() : folder.filename() / below).generic_string();
}

std::string value_of(std::string_view word, const SourceClip& source, const Preset& preset) {
  if (word == "stem") return fs::path(source.path).stem().string();
  if (word == "folder") return source.folder.empty() ? "." : source.folder;
  if (word == "preset") return slug(preset.name);
  if (word == "method") return preset.method;
  throw Error("{" + std::string(word) +
              "} means nothing in a name: there are {folder}, {stem}, {preset} and {method}");
}

std::string_view without_format(std::string_view pattern) {
  const std::size_t dot = pattern.rfind('.');
  if (dot != pattern.npos && output_format(pattern.substr(dot + 1))) return pattern.substr(0, dot);
  return pattern;
}

}  // namespace

std::string_view name(OutputFormat format) {
  return kFormatNames[static_cast<std::size_t>(format)];
}

std::optional<OutputFormat> output_format(std::string_view name) {
  for (const OutputFormat format : kOutputFormats)
    if (mocapress::name(format) == name) return format;
  return std::nullopt;
}

std::vector<SourceClip> find_sources(const std::vector<std::string>& inputs) {
  std::vector<SourceClip> sources;
  std::unordered_set<std::string> found;
  const auto add = [&](SourceClip source) {
    if (found.insert(source.path).second) sources.push_back(std::move(source));
  };
  for (const std::string& input : inputs) {
    try {
      for (const fs::path& clip : find_clips({input}))
        add({clip.string(), folder_of(input, clip), {}});
    } catch (const InputError& error) {
      add({input, "", error.what()});
    }
  }
  return sources;
}

std::string output_name(std::string_view pattern, const SourceClip& source, const Preset& preset) {
  const std::string_view kept = without_format(pattern);
  std::string text;
  for (std::size_t at = 0; at < kept.size();) {
    const std::size_t open = kept.find('{', at);
    text.append(kept.substr(at, open - at));
    if (open == kept.npos) break;
    const std::size_t close = kept.find('}', open);
    if (close == kept.npos) throw Error("a name has a { without its }: " + std::string(pattern));
    text += value_of(kept.substr(open + 1, close - open - 1), source, preset);
    at = close + 1;
  }
  const fs::path path = fs::path(text).lexically_normal();
  const bool leaves = path.is_absolute() || (!path.empty() && *path.begin() == "..");
  if (leaves || !path.has_filename() || path == ".")
    throw Error("is no name of a file below the batch's folder: " + text);
  return path.generic_string();
}

void add_items(Batch& batch, const std::vector<SourceClip>& sources, std::size_t preset,
               std::string_view pattern) {
  for (const SourceClip& source : sources)
    batch.items.push_back({.input = source.path,
                           .output = output_name(pattern, source, batch.presets[preset]),
                           .preset = preset,
                           .problem = source.problem});
}

void mark_collisions(Batch& batch) {
  std::unordered_map<std::string, const BatchItem*> first;
  for (BatchItem& item : batch.items) {
    const auto [at, is_first] = first.emplace(item.output, &item);
    if (is_first) continue;
    if (item.problem.empty())
      item.problem = item.input + " would be written to " + item.output + " as " +
                     at->second->input + " is: a name pattern with {folder} may keep them apart";
    std::string other;
    for (int n = 2;
         !first.emplace(other = item.output + " (" + std::to_string(n) + ")", &item).second;)
      ++n;
    item.output = other;
  }
}

bool Shard::has(const BatchItem& item) const {
  Fnv1a hash;
  hash.add(item.output);
  return hash.state() % static_cast<std::uint64_t>(count) == static_cast<std::uint64_t>(index - 1);
}

Shard parse_shard(std::string_view text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    if (second.ec == std::errc() && second.ptr == end && shard.index >= 1 &&
        shard.index <= shard.count)
      return shard;
  }
  throw Error("a shard is written i/n, i from 1 to n, not " + std::string(text));
}

std::string fingerprint(const Batch& batch) {
  Fnv1a hash;
  for (const BatchItem& item : batch.items) hash.add(item.output + '\n');
  return hash.text();
}

}  // namespace mocapress
