// SPDX-License-Identifier: MIT
// Reads and writes .mcpr files. FORMAT.md describes their layout and what a reader rejects.
#pragma once

#include <span>

#include "core/codec/format/compressed_clip.h"

namespace mocapress {

/// Throws Error where the clip is too large for a file: check_room().
std::vector<std::byte> write_container(const CompressedClip& clip);

/// Reads a file with a wavelet motion. If it has tiers (tiers.h), reads the first `tiers` of them,
/// and the bytes may end there; 0: all. Throws FormatError unless the bytes are a whole, intact
/// file of a known version.
CompressedClip read_container(std::span<const std::byte> bytes, int tiers = 0);

/// A clip and its motion: wavelets, or the payload of a comparison method's COMP section, which
/// core/baselines understands. For the latter basis, coding and provenance.method have no meaning.
struct Container {
  CompressedClip clip;
  bool of_comparison = false;
};

std::vector<std::byte> write_container(const Container& container);
/// The sections of a file, checked against the format's limits. Throws FormatError.
runtime::FileSections sections_of(std::span<const std::byte> bytes, int tiers = 0);

Container read_any_container(std::span<const std::byte> bytes, int tiers = 0);

}  // namespace mocapress
