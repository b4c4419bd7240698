// SPDX-License-Identifier: MIT
// Converts a .mcpr to a clip of a packed bank and back, byte for byte: FORMAT.md, "Packed clips".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/runtime/format/packed_clip.h"

namespace mocapress {

/// Returns the number of an item in the bank. Adds the item unless the bank has an equal one.
using InternItem =
    std::function<std::uint32_t(runtime::BankItem kind, std::span<const std::byte> bytes)>;

/// The bytes that each tier but the first adds to a clip: tiers.h.
using ClipPieces = std::vector<std::vector<std::byte>>;

/// A clip prepared for a bank, not added to one yet.
struct PackedClip {
  struct Section {
    std::array<char, 4> tag;
    std::vector<std::byte> part;  // empty: stored with the clip itself
  };
  std::vector<Section> sections;
  std::uint16_t orders_head = 0;  // number of order bytes, and flag of long errors
  std::vector<std::byte> bytes;
  ClipPieces pieces;
};

/// Codes the motion with the bank's learned priors (learned_priors.h) where that takes fewer bytes
/// and the file has no tiers.
/// Throws FormatError where the file is no .mcpr.
PackedClip pack_clip(std::span<const std::byte> file, std::span<const std::byte> learned = {});

/// Adds the clip's parts and its outline to the items of a bank. Returns the outline's number.
std::uint32_t intern_outline(const PackedClip& clip, const InternItem& intern);

/// Restores the file that was packed. If the bank lacks the finer tiers, the result is a file
/// without tiers, with the motion of the tiers that the bank has. Throws FormatError.
std::vector<std::byte> unpack_clip(const mcpk_bank& bank, const runtime::BankEntry& entry);

/// Copies an outline with its parts to another bank. Returns the outline's number there.
std::uint32_t copy_outline(const mcpk_bank& bank, std::uint32_t outline, const InternItem& intern);

}  // namespace mocapress
