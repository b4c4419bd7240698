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

/// Output formats. All but .mcpr hold the motion decoded from the .mcpr.
enum class OutputFormat { Mcpr, Bvh, Amc, Csv, Glb, Fbx, Review };

inline constexpr std::array<OutputFormat, 7> kOutputFormats = {
    OutputFormat::Mcpr, OutputFormat::Bvh, OutputFormat::Amc,   OutputFormat::Csv,
    OutputFormat::Glb,  OutputFormat::Fbx, OutputFormat::Review};

/// Name and extension of a format: "mcpr", "bvh", "amc" (comes with an .asf), "csv", "glb", "fbx",
/// "review.js" (shown by the report's viewer).
std::string_view name(OutputFormat format);

/// The format with this name, if there is one.
std::optional<OutputFormat> output_format(std::string_view name);

/// A clip found on disk. Paths are strings, which take less memory than std::filesystem::path.
struct SourceClip {
  std::string path;
  std::string folder;     // the searched folder's name and the folders below it: "walks/slow"
  std::string problem;    // why it cannot be read, if that is known already; empty: no problem
  std::string take = {};  // name of an animation, if the file has several: part of {stem}

  bool operator==(const SourceClip&) const = default;
};

/// Finds clips: each input that is a file, and every clip below inputs that are folders, in the
/// order of their names, each once. An input that is absent, unreadable or without clips becomes a
/// clip with a problem. A folder `outputs` below an input is skipped, since the results of a batch
/// are not its inputs.
std::vector<SourceClip> find_sources(const std::vector<std::string>& inputs,
                                     const std::string& outputs = {});

/// All that defines a batch, except its folder.
struct Batch {
  std::vector<Settings> presets;
  std::vector<OutputFormat> formats = {OutputFormat::Mcpr};
  ReadOptions reading;
  WriteOptions writing;  // for formats other than .mcpr
  // Form of the bank that is made of the .mcpr files at the end. Unset: no bank.
  std::optional<runtime::BankForm> bank;
  bool learn = false;  // true: learn from the clips how to code them; packed banks only
  ItemList items;

  const ReadOptions& reading_of(const BatchItem& item) const {
    return item.reading ? *item.reading : reading;
  }
};

inline constexpr const char* kUsualNames = "{folder}/{stem}";

/// Makes a clip's output, a path without extension below the batch's folder, from a pattern of
/// {folder}, {stem}, {type} (the source's extension), {preset} and {method}. An extension at the
/// end of the pattern is dropped if it is that of a format, since each file gets its own. Throws
/// Error for any other {word}, for an empty name, and for a path outside the folder.
std::string output_name(std::string_view pattern, const SourceClip& source, const Settings& preset);

/// Adds an item for each source, with the preset at index `preset`. If the pattern makes no valid
/// output from a source's name, its item gets a problem. Throws Error for a pattern that is invalid
/// for any clip.
void add_items(Batch& batch, const std::vector<SourceClip>& sources, std::size_t preset,
               std::string_view pattern);

/// Throws Error for a batch that cannot be run: one with a bank but without .mcpr files, with a
/// bank that is to learn but is not packed, or with a format that this build cannot write.
void check(const Batch& batch);

/// Makes all outputs differ: an item whose output an earlier item has already gets another output,
/// and a problem.
void mark_collisions(Batch& batch);

/// One machine's part of a batch that several machines share. A clip's shard depends on its output
/// alone, so that adding or removing a clip does not move other clips to other shards.
struct Shard {
  int index = 1;  // from 1
  int count = 1;

  bool has(const BatchItem& item) const;
  bool operator==(const Shard&) const = default;
};

/// Parses "2/8": index and count. Throws Error.
Shard parse_shard(std::string_view text);

/// A hash of all outputs in their order. Shards with different fingerprints are not of the same
/// batch.
std::string fingerprint(const Batch& batch);

}  // namespace mocapress
