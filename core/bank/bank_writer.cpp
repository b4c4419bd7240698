// SPDX-License-Identifier: MIT
#include "core/bank/bank_writer.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/utf8_path.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/codec/format/varint.h"
#include "core/runtime/format/bank_tiers.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress {
namespace {

constexpr std::uint64_t kMostRegionBytes = 0xFFFFFFFFU;
constexpr std::size_t kTableAlignment = 32;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

template <typename T>
void append_value(std::vector<std::byte>& to, T value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  to.insert(to.end(), bytes.begin(), bytes.end());
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::uint32_t InternedBytes::intern(std::span<const std::byte> bytes) {
  const auto [at, is_new] =
      numbers_.try_emplace(std::string(text_of(bytes)), static_cast<std::uint32_t>(all_.size()));
  if (is_new) all_.push_back(&at->first);
  return at->second;
}

std::uint32_t SharedTables::intern(std::span<const std::byte> table) {
  const std::size_t place =
      (bytes_.size() + kTableAlignment - 1) / kTableAlignment * kTableAlignment;
  if (place + table.size() > kMostRegionBytes)
    throw WriteError("the tables of the bank would take more than 4 GiB");
  const auto [first, end] = places_.equal_range(std::hash<std::string_view>()(text_of(table)));
  for (auto at = first; at != end; ++at)
    if (at->second.bytes == table.size() &&
        std::ranges::equal(table, std::span(bytes_).subspan(at->second.place, table.size())))
      return at->second.place;
  places_.emplace(std::hash<std::string_view>()(text_of(table)),
                  Table{static_cast<std::uint32_t>(place), table.size()});
  bytes_.resize(place);
  bytes_.insert(bytes_.end(), table.begin(), table.end());
  return static_cast<std::uint32_t>(place);
}

BankWriter::BankWriter(const std::filesystem::path& path, runtime::BankForm form)
    : file_(path), form_(form) {
  write(std::vector<std::byte>(sizeof(mcpk_bank)));
}

std::uint32_t BankWriter::intern(runtime::BankItem kind, std::span<const std::byte> bytes) {
  return items_[static_cast<int>(kind)].intern(bytes);
}

void BankWriter::write(std::span<const std::byte> bytes) {
  file_.write(bytes);
  written_ += bytes.size();
}

void BankWriter::align(std::uint64_t alignment) {
  write(std::vector<std::byte>((alignment - written_ % alignment) % alignment));
}

std::uint32_t BankWriter::tag_set(std::vector<std::string> tags) {
  std::vector<std::uint32_t> numbers;
  for (std::string& tag : tags) {
    if (tag.empty() || tag.size() > runtime::kMostTextOfBank || tag.find('\0') != std::string::npos)
      throw InputError(tag, 0, 0, "a tag has 1 to 65535 bytes, and no zero");
    tag += '\0';
    numbers.push_back(intern(runtime::BankItem::Tag, bytes_of(tag)));
  }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return intern(runtime::BankItem::TagSet, std::as_bytes(std::span(numbers)));
}

void BankWriter::add(const std::string& name, std::uint32_t kind, std::span<const std::byte> bytes,
                     std::vector<std::string> tags, const ClipPieces& pieces) {
  if (name.empty() || name.size() > runtime::kMostNameOfClip ||
      name.find('\0') != std::string::npos)
    throw InputError(name, 0, 0, "a clip of a bank needs a name of 1 to 255 bytes");
  if (count_ == runtime::kMostClipsOfBank)
    throw InputError(name, 0, 0, "a bank has at most 2^24 clips");
  const bool follows =
      runtime::compare_names(last_name_.data(), last_name_.size(), name.data(), name.size()) < 0;
  if (count_ > 0 && !follows) throw InputError(name, 0, 0, "two clips of this name");
  if (form_ == runtime::BankForm::Cooked) {
    align(runtime::kCookedAlignment);
    clips_.push_back(written_);
  }
  if (count_ % runtime::kClipsOfBlock == 0) {
    end_block();
    append_value(blocks_, written_);
    append_value(blocks_, static_cast<std::uint32_t>(entries_.size()));
    append_value(blocks_, std::uint32_t{0});  // filled in by end_block()
  }
  put_entry(name, kind, tag_set(std::move(tags)), bytes.size());
  const auto checked = form_ == runtime::BankForm::Cooked
                           ? bytes.subspan(offsetof(mcpr_cooked, checksum), sizeof(std::uint32_t))
                           : bytes;
  checked_.insert(checked_.end(), checked.begin(), checked.end());
  write(bytes);
  while (tiers_.size() < pieces.size()) tiers_.push_back({{}, std::vector(count_, 0U)});
  for (std::size_t t = 0; t < tiers_.size(); ++t) {
    TierPieces& tier = tiers_[t];
    tier.begins.push_back(static_cast<std::uint32_t>(tier.bytes.size()));
    if (t < pieces.size()) tier.bytes.insert(tier.bytes.end(), pieces[t].begin(), pieces[t].end());
    if (tier.bytes.size() > kMostRegionBytes)
      throw WriteError("a tier of the bank would take more than 4 GiB");
  }
  ++count_;
}

void BankWriter::put_entry(const std::string& name, std::uint32_t kind, std::uint32_t tags,
                           std::uint64_t size) {
  using namespace runtime;
  const bool is_first = count_ % kClipsOfBlock == 0;
  if (is_first) last_name_.clear();
  std::size_t kept = 0;
  while (kept < last_name_.size() && name[kept] == last_name_[kept]) ++kept;
  const std::size_t dropped = last_name_.size() - kept;
  const std::size_t more = name.size() - kept - 1;
  const bool has_kind = is_first || kind != last_kind_;
  const bool has_tags = is_first || tags != last_tags_;
  entries_.push_back(
      static_cast<std::byte>(std::min<std::size_t>(dropped, kNameMask) |
                             std::min<std::size_t>(more, kNameMask) << kNewNameShift |
                             (has_kind ? kHasKind : 0U) | (has_tags ? kHasTags : 0U)));
  for (const std::size_t part : {dropped, more})
    if (part >= kNameMask) write_varint(entries_, part - kNameMask);
  const auto rest = bytes_of(name).subspan(kept);
  entries_.insert(entries_.end(), rest.begin(), rest.end());
  write_varint(entries_, size);
  if (has_kind) write_varint(entries_, kind);
  if (has_tags) write_varint(entries_, tags);
  last_name_ = name;
  last_kind_ = kind;
  last_tags_ = tags;
}

/// Writes the checksum of the latest block, if there is one.
void BankWriter::end_block() {
  if (blocks_.empty()) return;
  const std::uint32_t checksum = runtime::bank_checksum(checked_.data(), checked_.size());
  std::memcpy(&blocks_[blocks_.size() - sizeof checksum], &checksum, sizeof checksum);
  checked_.clear();
}

runtime::BankRegion BankWriter::write_region(std::span<const std::byte> bytes,
                                             std::uint64_t alignment, std::uint32_t& checksum) {
  align(alignment);
  if (bytes.size() > kMostRegionBytes)
    throw WriteError("what clips share, or the index, would take more than 4 GiB");
  checksum = runtime::bank_checksum(bytes.data(), bytes.size());
  const runtime::BankRegion region{written_, bytes.size()};
  write(bytes);
  return region;
}

/// Returns the table of the finer tiers. The tiers themselves are written right after it.
std::vector<std::byte> BankWriter::tier_table() const {
  std::vector<std::byte> table;
  if (tiers_.empty()) return table;
  const std::size_t tiers = tiers_.size() + 1;
  std::uint64_t offset = (written_ + kTableAlignment - 1) / kTableAlignment * kTableAlignment +
                         runtime::tier_table_bytes(tiers, count_);
  append_value(table, static_cast<std::uint32_t>(tiers));
  for (const TierPieces& tier : tiers_) {
    append_value(table, offset);
    append_value(table, std::uint64_t{tier.bytes.size()});
    append_value(table, runtime::bank_checksum(tier.bytes.data(), tier.bytes.size()));
    offset += tier.bytes.size();
  }
  for (const TierPieces& tier : tiers_) {
    for (const std::uint32_t begin : tier.begins) append_value(table, begin);
    append_value(table, static_cast<std::uint32_t>(tier.bytes.size()));
  }
  return table;
}

std::vector<std::byte> BankWriter::item_bytes(const BankTexts& texts, mcpk_bank& head) {
  std::vector<const std::string*> all;
  for (int k = 0; k < runtime::kBankItems - 1; ++k) {
    const auto& items = items_[k].all();
    head.item_counts[k] = static_cast<std::uint32_t>(items.size());
    all.insert(all.end(), items.begin(), items.end());
  }
  std::vector<std::string> written;
  for (const auto& [key, value] : texts)
    for (const std::string& text : {key, value}) written.push_back(text + '\0');
  for (const std::string& text : written) all.push_back(&text);
  head.item_counts[runtime::kBankItems - 1] = static_cast<std::uint32_t>(written.size());
  std::vector<std::byte> bytes;
  std::size_t end = 4 * (all.size() + 1);
  append_value(bytes, static_cast<std::uint32_t>(end));
  for (const std::string* item : all) {
    end += item->size();
    append_value(bytes, static_cast<std::uint32_t>(std::min<std::size_t>(end, kMostRegionBytes)));
  }
  bytes.reserve(end);
  for (const std::string* item : all) {
    const auto own = bytes_of(*item);
    bytes.insert(bytes.end(), own.begin(), own.end());
  }
  return bytes;
}

void BankWriter::finish(const BankTexts& texts) {
  end_block();
  mcpk_bank head{};
  std::memcpy(head.magic, mcpk_bank::kMagic, sizeof head.magic);
  head.version = mcpk_bank::kVersion;
  head.form = form_;
  head.clips = count_;
  head.items = write_region(item_bytes(texts, head), 4, head.items_checksum);
  std::vector<std::byte> index;
  for (std::size_t block = 0; block < blocks_.size(); block += runtime::kBlockBytes) {
    std::uint32_t entry = 0;
    const auto first = blocks_.begin() + static_cast<std::ptrdiff_t>(block);
    std::memcpy(&entry, &*first + 8, sizeof entry);
    index.insert(index.end(), first, first + 8);
    append_value(index, entry + static_cast<std::uint32_t>(blocks_.size()));
    index.insert(index.end(), first + 12, first + 16);
  }
  index.insert(index.end(), entries_.begin(), entries_.end());
  head.index = write_region(index, 1, head.index_checksum);
  const bool is_cooked = form_ == runtime::BankForm::Cooked;
  head.tables = write_region(is_cooked ? tables_.bytes() : tier_table(), runtime::kCookedAlignment,
                             head.tables_checksum);
  for (const TierPieces& tier : tiers_) write(tier.bytes);
  for (const std::uint64_t clip : clips_) {
    const auto distance = static_cast<std::int64_t>(head.tables.offset - clip);
    file_.write_at(clip + offsetof(mcpr_cooked, tables), std::as_bytes(std::span(&distance, 1)));
  }
  head.bytes = written_;
  head.checksum = runtime::bank_checksum(&head, offsetof(mcpk_bank, checksum));
  file_.write_at(0, std::as_bytes(std::span(&head, 1)));
  const MappedFile written = file_.map_back();
  const mcpk_bank* bank = nullptr;
  mcpr_result result;
  mcpk_open(written.bytes().data(), written.bytes().size(), 1, &bank, &result);
  if (runtime::failed(result))
    throw WriteError(utf8(file_.path()) + ": does not read back: " + result.message);
  file_.commit();
}

}  // namespace mocapress
