// SPDX-License-Identifier: MIT
// From a .mcpr to a clip of a packed bank and back, byte for byte: FORMAT.md, "Packed clips".
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/codec/format/packed_clip.h"

namespace mocapress {

/// Gives the number of an item of the bank, which has each once.
using InternItem =
    std::function<std::uint32_t(runtime::BankItem kind, std::span<const std::byte> bytes)>;

struct PackedClip {
  std::uint32_t outline = 0;
  std::vector<std::byte> bytes;
};

/// Its motion is coded by what clips of the bank taught (learned_priors.h) where that takes fewer
/// bytes. Throws FormatError where the file is no .mcpr.
PackedClip pack_clip(std::span<const std::byte> file, const InternItem& intern,
                     std::span<const std::byte> learned = {});

/// The file that was packed. Throws FormatError.
std::vector<std::byte> unpack_clip(const mcpk_bank& bank, const runtime::BankEntry& entry);

/// The outline with its parts, in another bank.
std::uint32_t copy_outline(const mcpk_bank& bank, std::uint32_t outline, const InternItem& intern);

void write_varint(std::vector<std::byte>& bytes, std::uint64_t value);

}  // namespace mocapress
