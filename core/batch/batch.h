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

/// What is made of a clip. All but the first are the motion as it comes out of the .mcpr.
enum class OutputFormat { Mcpr, Bvh, Amc, Csv, Glb, Fbx, Review };

inline constexpr std::array<OutputFormat, 7> kOutputFormats = {
    OutputFormat::Mcpr, OutputFormat::Bvh, OutputFormat::Amc,   OutputFormat::Csv,
    OutputFormat::Glb,  OutputFormat::Fbx, OutputFormat::Review};

/// "mcpr", "bvh", "amc" (with its .asf beside it), "csv", "glb", "fbx", "review.js" (what the
/// report's viewer shows): the extension too.
std::string_view name(OutputFormat format);

/// Unset when it is none of them.
std::optional<OutputFormat> output_format(std::string_view name);

/// A clip as it was found. Paths are texts: a long list of std::filesystem::path is heavy.
struct SourceClip {
  std::string path;
  std::string folder;   // the folder it was found by, by name, and those between: "walks/slow"
  std::string problem;  // why it cannot be read, known beforehand; else empty

  bool operator==(const SourceClip&) const = default;
};

/// Files as they are, and every clip below the folders, in the order of their names, each
/// once. What is not there, cannot be read or holds no clip is a clip with a problem. A folder
/// `outputs` below an input is left out of it: what a batch writes is not its input.
std::vector<SourceClip> find_sources(const std::vector<std::string>& inputs,
                                     const std::string& outputs = {});

/// Everything that is asked for, but where it goes.
struct Batch {
  std::vector<Settings> presets;
  std::vector<OutputFormat> formats = {OutputFormat::Mcpr};
  ReadOptions reading;
  WriteOptions writing;                   // of formats other than .mcpr
  std::optional<runtime::BankForm> bank;  // made of the .mcpr files when all are done
  bool learn = false;  // the bank, a packed one, codes motions by what its clips teach
  ItemList items;

  const ReadOptions& reading_of(const BatchItem& item) const {
    return item.reading ? *item.reading : reading;
  }
};

inline constexpr const char* kUsualNames = "{folder}/{stem}";

/// The output of a clip by a pattern of {folder}, {stem}, {type} (its extension), {preset}
/// and {method}. An extension of
/// one of the formats at its end is left out: each file gets its own. Throws Error on any other
/// {word}, an empty name and one that leaves the folder.
std::string output_name(std::string_view pattern, const SourceClip& source, const Settings& preset);

/// An item of each, with the preset of that index. A clip whose name makes no output's is an item
/// with a problem. Throws Error for a pattern that no clip fits.
void add_items(Batch& batch, const std::vector<SourceClip>& sources, std::size_t preset,
               std::string_view pattern);

/// Throws Error for what cannot be made: a bank without .mcpr files, a bank that is to learn and is
/// not packed.
void check(const Batch& batch);

/// Gives every item that would be written where an earlier one is a problem that says so, and
/// another output: no two items have the same.
void mark_collisions(Batch& batch);

/// The part of a batch that one of several machines does: clips belong to a shard by their output's
/// name alone, so that a clip more or less moves no other.
struct Shard {
  int index = 1;  // from 1
  int count = 1;

  bool has(const BatchItem& item) const;
  bool operator==(const Shard&) const = default;
};

/// "2/8". Throws Error.
Shard parse_shard(std::string_view text);

/// Changes with any output's name or their order: tells shards of one batch from others.
std::string fingerprint(const Batch& batch);

}  // namespace mocapress
