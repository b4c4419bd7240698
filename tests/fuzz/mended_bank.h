// SPDX-License-Identifier: MIT
// Corrects the checksums of any bytes as a bank or cooked clip, so that readers reach the bytes
// behind them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/bank.h"
#include "core/runtime/own_memory.h"
#include "core/runtime/pose/cooked_check.h"

namespace mocapress::test {

class MendedBank {
 public:
  MendedBank(const std::uint8_t* data, std::size_t size)
      : memory_(std::max({size, sizeof(mcpk_bank), sizeof(mcpr_cooked)})), size_(size) {
    std::memset(memory_.data(), 0, memory_.size());
    if (size > 0) std::memcpy(memory_.data(), data, size);
    if (size >= sizeof(mcpr_cooked)) mend_cooked(memory_.data(), size);
    if (size >= sizeof(mcpk_bank)) mend_bank();
  }

  const std::byte* data() const { return memory_.data(); }

 private:
  /// Null if the bytes are no cooked clip.
  static const mcpr_cooked* mend_cooked(std::byte* bytes, std::size_t size) {
    auto* const clip = reinterpret_cast<mcpr_cooked*>(bytes);
    if (size < sizeof *clip || runtime::check_cooked_head(*clip, size).status != MCPR_OK)
      return nullptr;
    clip->checksum = runtime::checksum_of(*clip);
    return clip;
  }

  /// Corrects a checksum whose region lies within the bytes.
  void mend(const runtime::BankRegion& region, std::uint32_t& checksum) {
    if (region.offset <= size_ && region.bytes <= size_ - region.offset)
      checksum = runtime::bank_checksum(memory_.data() + region.offset,
                                        static_cast<std::size_t>(region.bytes));
  }

  /// Corrects the checksums of clips at the places in an index, and of their block.
  void mend_block(const mcpk_bank& bank, std::uint32_t block) {
    runtime::BankEntry entry;
    std::uint32_t own[runtime::kClipsOfBlock];
    std::size_t count = 0;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    for (runtime::EntryWalk clips(bank, block); clips.next(entry); ++count) {
      if (count == 0) begin = entry.place.offset;
      end = entry.place.offset + entry.place.bytes;
      if (!bank.is_cooked()) continue;
      const mcpr_cooked* const clip = mend_cooked(memory_.data() + entry.place.offset,
                                                  static_cast<std::size_t>(entry.place.bytes));
      if (clip == nullptr) return;
      own[count] = clip->checksum;
    }
    const std::uint32_t checksum =
        bank.is_cooked()
            ? runtime::bank_checksum(own, count * sizeof *own)
            : runtime::bank_checksum(memory_.data() + begin, static_cast<std::size_t>(end - begin));
    std::memcpy(
        memory_.data() + bank.index.offset + runtime::kBlockBytes * (block + 1) - sizeof checksum,
        &checksum, sizeof checksum);
  }

  void mend_bank() {
    constexpr std::uint32_t kMostBlocks = 64;
    auto* const head = reinterpret_cast<mcpk_bank*>(memory_.data());
    const auto mend_head = [head] {
      head->checksum = runtime::bank_checksum(head, offsetof(mcpk_bank, checksum));
    };
    mend_head();
    if (runtime::check_bank_head(*head, size_).status == MCPR_OK)
      for (std::uint32_t block = 0; block < std::min(head->blocks(), kMostBlocks); ++block)
        mend_block(*head, block);
    mend(head->index, head->index_checksum);
    mend(head->items, head->items_checksum);
    mend(head->tables, head->tables_checksum);
    mend_head();
  }

  AlignedBytes memory_;
  std::size_t size_;
};

}  // namespace mocapress::test
