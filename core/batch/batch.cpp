// SPDX-License-Identifier: MIT
#include "core/batch/batch.h"

#include <algorithm>
#include <charconv>
#include <unordered_map>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/file_identity.h"
#include "core/base/fnv1a.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/formats/clip_files.h"
#include "core/report/review_page.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kFormatNames = {"mcpr", "bvh", "amc",      "csv",
                                                          "glb",  "fbx", "review.js"};

/// The last part of the folder's real path: "walks" for "../walks", for "walks/", and for "." in
/// walks.
std::string name_of_folder(const fs::path& folder) {
  std::error_code error;
  const fs::path canonical = fs::canonical(folder, error);
  if (error) throw InputError(utf8(folder), 0, 0, error.message());
  return utf8((canonical.has_filename() ? canonical : canonical.parent_path()).filename());
}

/// Finds the clips below a folder, in the order of their names. Clips that cannot be read are
/// included, with the problem.
std::vector<SourceClip> sources_below(const fs::path& folder,
                                      const std::optional<FileIdentity>& left_out) {
  const std::string found_by = name_of_folder(folder);
  std::vector<SourceClip> sources;
  for (const FoundClip& clip : clips_below(folder, left_out)) {
    const fs::path below = clip.path.lexically_relative(folder).parent_path();
    const std::string path = utf8(clip.path);
    sources.push_back({path, below.empty() ? found_by : generic_utf8(utf8_path(found_by) / below),
                       clip.problem.empty() ? "" : InputError(path, 0, 0, clip.problem).what()});
  }
  if (sources.empty())
    throw InputError(utf8(folder), 0, 0, "holds none of " + readable_extensions(", "));
  return sources;
}

std::vector<SourceClip> sources_of(const std::string& input, const std::string& outputs) {
  try {
    const PathKind kind = path_kind(utf8_path(input));
    if (kind == PathKind::Absent) return {{input, "", input + ": No such file or directory"}};
    if (kind != PathKind::Folder) return {{input, "", ""}};
    std::optional<FileIdentity> left_out;
    if (!outputs.empty()) left_out = identity_of(utf8_path(outputs));
    if (left_out == identity_of(utf8_path(input))) left_out.reset();
    return sources_below(utf8_path(input), left_out);
  } catch (const InputError& problem) {
    return {{input, "", problem.what()}};
  }
}

std::string value_of(std::string_view word, const SourceClip& source, const Settings& preset) {
  if (word == "stem") {
    const std::string stem = utf8(utf8_path(source.path).stem());
    return source.take.empty() ? stem : stem + "-" + slug(source.take);
  }
  if (word == "folder") return source.folder.empty() ? "." : source.folder;
  if (word == "type") {
    const std::string extension = utf8(utf8_path(source.path).extension());
    return extension.empty() ? "" : slug(extension.substr(1));
  }
  if (word == "preset") return slug(preset.name);
  if (word == "method") return preset.method;
  throw Error(
      "{" + std::string(word) +
      "} means nothing in a name: there are {folder}, {stem}, {type}, {preset} and {method}");
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

std::vector<SourceClip> find_sources(const std::vector<std::string>& inputs,
                                     const std::string& outputs) {
  std::vector<SourceClip> sources;
  std::unordered_set<std::string> found;
  for (const std::string& input : inputs)
    for (SourceClip& source : sources_of(input, outputs))
      if (inputs.size() == 1 || found.insert(source.path).second)
        sources.push_back(std::move(source));
  return sources;
}

std::string output_name(std::string_view pattern, const SourceClip& source,
                        const Settings& preset) {
  const std::string_view kept = without_format(pattern);
  std::string text;
  for (std::size_t at = 0; at < kept.size();) {
    const std::size_t open = kept.find('{', at);
    text.append(kept.substr(at, open - at));
    if (open == kept.npos) break;
    const std::size_t close = kept.find('}', open);
    if (close == kept.npos)
      throw Error("the name pattern has a { without its }: " + std::string(pattern));
    text += value_of(kept.substr(open + 1, close - open - 1), source, preset);
    at = close + 1;
  }
  const fs::path path = utf8_path(text).lexically_normal();
  const bool leaves = path.has_root_path() || (!path.empty() && *path.begin() == "..");
  if (leaves || !path.has_filename() || path == ".")
    throw Error("is not a file name below the batch's folder: " + text);
  return generic_utf8(path);
}

void add_items(Batch& batch, const std::vector<SourceClip>& sources, std::size_t preset,
               std::string_view pattern) {
  const Settings& settings = batch.presets[preset];
  output_name(pattern, {"clip.bvh", "folder", {}}, settings);
  for (const SourceClip& source : sources) {
    BatchItem item{
        .input = source.path, .output = "unnamed", .preset = preset, .problem = source.problem};
    try {
      item.output = output_name(pattern, source, settings);
    } catch (const Error& error) {
      if (item.problem.empty()) item.problem = source.path + ": its output's name " + error.what();
    }
    batch.items.push_back(item);
  }
}

void check(const Batch& batch) {
  if (batch.bank && std::ranges::find(batch.formats, OutputFormat::Mcpr) == batch.formats.end())
    throw Error("a bank is made of .mcpr files, which are not among the formats");
  if (batch.learn && batch.bank != runtime::BankForm::Packed)
    throw Error("only a packed bank is coded by what its clips teach");
  if (std::ranges::find(batch.formats, OutputFormat::Review) != batch.formats.end() &&
      !has_review_viewer())
    throw Error(kNoReviewViewer);
}

void mark_collisions(Batch& batch) {
  // Index of the first item with an output, by the hash of that output.
  std::unordered_map<std::uint64_t, std::size_t> first;
  const auto place = [&](const std::string& output, std::size_t index) {
    Fnv1a hash;
    hash.add(name_key(output));
    return first.emplace(hash.state(), index);
  };
  const auto find_place = [&](std::size_t i) {
    BatchItem item = batch.items[i];
    const auto [at, is_first] = place(item.output, i);
    if (is_first) return;
    const std::string other = batch.items[at->second].input;
    const bool of_one_type = utf8_path(item.input).extension() == utf8_path(other).extension();
    if (item.problem.empty())
      item.problem = item.input + " would be written to " + item.output + " as " + other +
                     " is: a name pattern with " + (of_one_type ? "{folder}" : "{type}") +
                     " may keep them apart";
    const std::string taken = item.output;
    int n = 2;
    do item.output = taken + " (" + std::to_string(n++) + ")";
    while (!place(item.output, i).second);
    batch.items.replace(i, item);
  };
  // Clips with a problem come last, so that they take no name from other clips.
  std::vector<std::size_t> problems;
  for (std::size_t i = 0; i < batch.items.size(); ++i)
    if (const BatchItem item = batch.items[i]; item.problem.empty())
      find_place(i);
    else
      problems.push_back(i);
  for (const std::size_t i : problems) find_place(i);
  batch.items.shrink();
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
  for (const BatchItem item : batch.items) hash.add(item.output + '\n');
  return hash.text();
}

}  // namespace mocapress
