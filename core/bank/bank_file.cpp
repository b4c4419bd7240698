// SPDX-License-Identifier: MIT
#include "core/bank/bank_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/runtime/bank/bank_check.h"
#include "core/runtime/format/file_sections.h"

namespace mocapress {

namespace {

AlignedBytes read_aligned(const std::filesystem::path& path) {
  const std::vector<std::byte> read = read_bytes(path);
  AlignedBytes bytes(read.size());
  std::ranges::copy(read, bytes.data());
  return bytes;
}

}  // namespace

std::optional<mcpk_bank> read_bank_head(const std::filesystem::path& path) {
  mcpk_bank head{};
  const FileDescriptor file = open_to_read(path);
  const auto got = read_all(file.number(), 0, reinterpret_cast<char*>(&head), sizeof head);
  if (!got) throw InputError(utf8(path), 0, 0, std::strerror(errno));
  if (*got == 0) return std::nullopt;
  return head;
}

BankFile::BankFile(const std::filesystem::path& path)
    : path_(utf8(path)), bytes_(read_aligned(path)) {
  if (bytes_.size() == 0) throw InputError(path_, 0, 0, "not a bank of clips");
  mcpr_result result;
  mcpk_open(bytes_.data(), bytes_.size(), 1, &bank_, &result);
  require_of(result);
  if (bank_->bytes != bytes_.size())
    throw InputError(path_, 0, 0, "bytes after the end of the bank");
}

void BankFile::require_of(const mcpr_result& result) const {
  try {
    require(result);
  } catch (const FormatError& error) {
    throw InputError(path_, 0, 0, error.what());
  }
}

runtime::BankEntry BankFile::entry(std::uint32_t clip) const {
  runtime::BankEntry entry;
  if (!runtime::read_entry(*bank_, clip, entry)) throw Error(path_ + ": no such clip");
  return entry;
}

std::uint32_t BankFile::find(std::string_view name) const {
  const std::int64_t clip = runtime::find_clip(*bank_, name.data(), name.size());
  if (clip < 0) throw InputError(path_, 0, 0, "holds no clip '" + std::string(name) + "'");
  return static_cast<std::uint32_t>(clip);
}

std::vector<std::string> BankFile::tags(const runtime::BankEntry& entry) const {
  std::vector<std::string> tags;
  runtime::Cursor numbers = bank_->item(runtime::BankItem::TagSet, entry.tag_set).cursor();
  while (!numbers.at_end())
    tags.emplace_back(bank_->text(runtime::BankItem::Tag, numbers.read<std::uint32_t>()));
  return tags;
}

BankTexts BankFile::texts() const {
  BankTexts texts;
  for (std::uint32_t t = 0; t < mcpr::describe(bank_).texts; ++t)
    texts.emplace_back(mcpk_key(bank_, t), mcpk_value(bank_, t));
  return texts;
}

BankClip BankFile::describe(std::uint32_t clip) const {
  const runtime::BankEntry found = entry(clip);
  BankClip described{found.name, tags(found), found.place.bytes};
  if (is_cooked()) {
    const mcpr_cooked_info info = mcpr::describe(cooked(found));
    described.sample_rate_hz = info.sample_rate;
    described.frames = static_cast<int>(info.frames);
    described.joints = static_cast<int>(info.joints);
    return described;
  }
  runtime::FileSections sections;
  require_of(runtime::read_sections(*bank_, found, mcpr::default_limits(), sections));
  described.sample_rate_hz = sections.sample_rate;
  described.frames = static_cast<int>(sections.frames);
  described.joints = static_cast<int>(sections.joints);
  described.motion_bytes = sections.motion_bytes();
  for (int t = 1; t < sections.tiers_read; ++t) described.bytes += sections.piece(t).size;
  return described;
}

const mcpr_cooked* BankFile::cooked(const runtime::BankEntry& entry) const {
  const mcpr_cooked* cooked = nullptr;
  require_of(runtime::cooked_clip_of(*bank_, entry, cooked));
  return cooked;
}

std::vector<std::byte> BankFile::extract(const runtime::BankEntry& entry) const {
  if (is_cooked())
    throw InputError(path_, 0, 0, "the bank is cooked, and holds no .mcpr files to extract");
  try {
    return unpack_clip(*bank_, entry);
  } catch (const FormatError& error) {
    throw InputError(path_, 0, 0, error.what());
  }
}

bool BankFile::play(std::uint32_t clip) const {
  if (is_cooked()) {
    const mcpr_cooked* cooked = nullptr;
    mcpr_result result;
    mcpk_cooked(bank_, clip, &cooked, &result);
    require_of(result);
    const mcpr_sample_request request{};
    std::vector<float> pose(mcpr_sample_values(cooked, &request));
    for (const double at : {0.0, mcpr::describe(cooked).frames - 1.0}) {
      mcpr_sample(cooked, &request, at, pose.data(), &result);
      require_of(result);
    }
    return true;
  }
  const mcpr::Owned<const mcpr_clip> loaded = load(clip);
  if (!loaded) return false;
  const mcpr_clip* const played = loaded.get();
  const mcpr_request request{.output = MCPR_LOCAL};
  const AlignedBytes working(mcpr_scratch_bytes(played, &request));
  std::vector<float> pose(mcpr_frame_values(played, &request));
  const std::uint32_t frames = mcpr::describe(played).frames;
  if (frames == 0) return true;
  for (const double at : {0.0, frames - 1.0}) {
    mcpr_result result;
    mcpr_decode_moment(played, &request, at, pose.data(), working.data(), working.size(), &result);
    require_of(result);
  }
  return true;
}

mcpr::Owned<const mcpr_clip> BankFile::load(std::uint32_t clip) const {
  auto loaded = mcpr::load(bank_, clip);
  if (loaded.result.status != MCPR_UNSUPPORTED) require_of(loaded.result);
  return std::move(*loaded);
}

std::uint64_t BankFile::skeleton_hash(std::uint32_t clip) const {
  if (is_cooked()) return mcpk_skeleton_hash(bank_, clip);
  return mcpr_skeleton_hash(load(clip).get());
}

SkeletonsInBank BankFile::skeletons() const {
  SkeletonsInBank skeletons;
  std::map<std::int32_t, std::uint32_t> by_number;
  std::map<std::uint64_t, std::uint32_t> by_hash;
  for (std::uint32_t clip = 0; clip < clips(); ++clip) {
    const std::int32_t number = mcpk_skeleton(bank_, clip);
    const auto known = by_number.find(number);
    auto at = static_cast<std::uint32_t>(skeletons.all.size());
    if (number >= 0 && known != by_number.end()) {
      at = known->second;
    } else {
      const std::uint64_t hash = skeleton_hash(clip);
      if (hash != 0) at = by_hash.try_emplace(hash, at).first->second;
      if (at == skeletons.all.size()) skeletons.all.push_back({.hash = hash, .clip = clip});
      if (number >= 0) by_number.emplace(number, at);
    }
    ++skeletons.all[at].clips;
    skeletons.of_clip.push_back(at);
  }
  return skeletons;
}

}  // namespace mocapress
