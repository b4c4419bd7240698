// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bank/bank_writer.h"
#include "core/runtime/format/bank.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"

namespace mocapress {

/// Properties of a clip, read from its bank.
struct BankClip {
  std::string name;
  std::vector<std::string> tags;
  std::uint64_t bytes = 0;  // size of all tiers, without data that clips share
  double sample_rate_hz = 0;
  int frames = 0;
  int joints = 0;
  std::uint64_t motion_bytes = 0;  // packed: the bytes that compression ratios count; cooked: 0
};

/// Reads the head of a bank without checking it; bytes that the file lacks are zero. Unset for an
/// empty file. Throws InputError.
std::optional<mcpk_bank> read_bank_head(const std::filesystem::path& path);

/// A skeleton that some of a bank's clips share.
struct SkeletonInBank {
  std::uint64_t hash = 0;   // mcpr_skeleton_hash; 0: no engine plays the clips
  std::uint32_t clip = 0;   // the first clip that has it
  std::uint32_t clips = 0;  // number of clips that have it
};

struct SkeletonsInBank {
  std::vector<SkeletonInBank> all;     // in the order of their first clips
  std::vector<std::uint32_t> of_clip;  // for each clip: index of its skeleton in `all`
};

/// A bank on disk, with all of its bytes checked. The whole file is read into memory: pages of a
/// mapped file would be lost if somebody cut the file short.
class BankFile {
 public:
  /// Throws InputError.
  explicit BankFile(const std::filesystem::path& path);

  const mcpk_bank& bank() const { return *bank_; }
  std::uint32_t clips() const { return bank_->clips; }
  bool is_cooked() const { return bank_->is_cooked(); }
  runtime::BankEntry entry(std::uint32_t clip) const;
  /// Returns the number of a clip. Throws InputError if the bank has no clip of this name.
  std::uint32_t find(std::string_view name) const;
  BankClip describe(std::uint32_t clip) const;
  std::vector<std::string> tags(const runtime::BankEntry& entry) const;
  BankTexts texts() const;
  /// Finds the skeletons of a packed bank by decoding one clip for each.
  SkeletonsInBank skeletons() const;

  /// Returns a clip of a cooked bank. Throws InputError if its bytes are not a valid clip.
  const mcpr_cooked* cooked(const runtime::BankEntry& entry) const;

  /// Returns the original .mcpr, byte for byte. From a stripped bank: a .mcpr with the motion of
  /// the tiers that are left. Throws Error for a clip of a cooked bank.
  std::vector<std::byte> extract(const runtime::BankEntry& entry) const;

  /// Checks that a clip plays: decodes its first and last frame with the runtime. Throws InputError
  /// if that fails. Returns false if no engine plays the clip's method (the paper's codings,
  /// comparison methods).
  bool play(std::uint32_t clip) const;

 private:
  void require_of(const mcpr_result& result) const;
  /// Decodes a clip of a packed bank; null if no engine plays it.
  mcpr::Owned<const mcpr_clip> load(std::uint32_t clip) const;
  std::uint64_t skeleton_hash(std::uint32_t clip) const;

  std::string path_;
  AlignedBytes bytes_;
  const mcpk_bank* bank_ = nullptr;
};

}  // namespace mocapress
