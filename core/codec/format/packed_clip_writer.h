// SPDX-License-Identifier: MIT
// From a .mcpr to a clip of a packed bank and back, byte for byte: FORMAT.md, "Packed clips".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/runtime/format/packed_clip.h"

namespace mocapress {

/// Gives the number of an item of the bank, which has each once.
using InternItem =
    std::function<std::uint32_t(runtime::BankItem kind, std::span<const std::byte> bytes)>;

/// A clip that is in no bank yet.
struct PackedClip {
  struct Section {
    std::array<char, 4> tag;
    std::vector<std::byte> part;  // empty: the clip has it itself
  };
  std::vector<Section> sections;
  std::uint16_t orders_head = 0;  // of the outline
  std::vector<std::byte> bytes;
};

/// Its motion is coded by what clips of the bank taught (learned_priors.h) where that takes fewer
/// bytes. Throws FormatError where the file is no .mcpr.
PackedClip pack_clip(std::span<const std::byte> file, std::span<const std::byte> learned = {});

/// Puts the parts of a clip among the items of a bank, and its outline, whose number it gives.
std::uint32_t intern_outline(const PackedClip& clip, const InternItem& intern);

/// The file that was packed. Throws FormatError.
std::vector<std::byte> unpack_clip(const mcpk_bank& bank, const runtime::BankEntry& entry);

/// The outline with its parts, in another bank.
std::uint32_t copy_outline(const mcpk_bank& bank, std::uint32_t outline, const InternItem& intern);

void write_varint(std::vector<std::byte>& bytes, std::uint64_t value);

}  // namespace mocapress
