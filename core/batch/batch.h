// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/batch/item_list.h"
#include "core/formats/motion_file.h"
#include "core/mocapress/settings.h"
#include "core/runtime/format/bank.h"

namespace mocapress {

/// Output formats. All but the first hold the motion decoded from the .mcpr.
enum class OutputFormat { Mcpr, Bvh, Amc, Csv, Glb, Fbx, Review };

inline constexpr std::array<OutputFormat, 7> kOutputFormats = {
    OutputFormat::Mcpr, OutputFormat::Bvh, OutputFormat::Amc,   OutputFormat::Csv,
    OutputFormat::Glb,  OutputFormat::Fbx, OutputFormat::Review};

/// "mcpr", "bvh", "amc" (with its .asf beside it), "csv", "glb", "fbx", "review.js" (what the
/// report's viewer shows): the extension too.
std::string_view name(OutputFormat format);

/// The format of this name; unset if there is none.
std::optional<OutputFormat> output_format(std::string_view name);

/// A clip found on disk. Paths are strings, since many objects of std::filesystem::path take much
/// memory.
struct SourceClip {
  std::string path;
  std::string folder;     // names of the searched folder and of those below it: "walks/slow"
  std::string problem;    // reason why it cannot be read, if known already; else empty
  std::string take = {};  // one of several animations in the file: part of {stem}; else empty

  bool operator==(const SourceClip&) const = default;
};

/// Finds clips: files as given, and every clip below the folders, in the order of their names, each
/// once. An input that is absent, unreadable or without clips becomes a clip with a problem. A
/// folder `outputs` below an input is skipped, since a batch's results are not its input.
std::vector<SourceClip> find_sources(const std::vector<std::string>& inputs,
                                     const std::string& outputs = {});

/// Everything asked of a batch except its folder.
struct Batch {
  std::vector<Settings> presets;
  std::vector<OutputFormat> formats = {OutputFormat::Mcpr};
  ReadOptions reading;
  WriteOptions writing;  // for formats other than .mcpr
  // Form of a bank made of the .mcpr files at the end; unset: none.
  std::optional<runtime::BankForm> bank;
  bool learn = false;  // true: the bank, which must be packed, learns its coding from its clips
  ItemList items;

  const ReadOptions& reading_of(const BatchItem& item) const {
    return item.reading ? *item.reading : reading;
  }
};

inline constexpr const char* kUsualNames = "{folder}/{stem}";

/// The output of a clip, from a pattern of {folder}, {stem}, {type} (its extension), {preset} and
/// {method}. If the pattern ends with an extension of one of the formats, it is dropped, since each
/// file gets its own. Throws Error for any other {word}, an empty name or a name outside the
/// folder.
std::string output_name(std::string_view pattern, const SourceClip& source, const Settings& preset);

/// Adds an item for each source, with the preset of that index. A source whose name makes no valid
/// output becomes an item with a problem. Throws Error for a pattern that fits no clip.
void add_items(Batch& batch, const std::vector<SourceClip>& sources, std::size_t preset,
               std::string_view pattern);

/// Throws Error for a batch that cannot be made: a bank without .mcpr files, or one that is to
/// learn but is not packed.
void check(const Batch& batch);

/// Gives a problem to every item whose output an earlier item already has, and another output, so
/// that all outputs differ.
void mark_collisions(Batch& batch);

/// One machine's part of a batch shared by several. A clip's shard depends on its output's name
/// alone, so adding or removing a clip moves no other.
struct Shard {
  int index = 1;  // from 1
  int count = 1;

  bool has(const BatchItem& item) const;
  bool operator==(const Shard&) const = default;
};

/// Reads "2/8". Throws Error.
Shard parse_shard(std::string_view text);

/// A hash of all outputs' names and their order, which tells the shards of one batch from others.
std::string fingerprint(const Batch& batch);

}  // namespace mocapress
