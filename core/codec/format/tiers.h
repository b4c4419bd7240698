// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 7, which wishes
// for level-of-detail streaming. Tiers of a .mcpr file: FORMAT.md, "TIER and FINE".
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/codec/format/compressed_clip.h"
#include "core/runtime/format/tiers.h"

namespace mocapress {

inline constexpr std::string_view kTiers = "TIER";
inline constexpr std::string_view kFine = "FINE";

struct TierError {
  float eps_cm = 0;  // in the clip's weighting, against the original
  float max_error_cm = 0;
};

/// Measures the first tiers of a file.
using MeasureTier = std::function<TierError(std::span<const std::byte> mcpr, int tiers)>;

/// Cuts the motion of a file into this many tiers, at most kMostTiers, of about as many bytes each,
/// so that the file's first bytes give a coarser motion. All tiers together give the same motion as
/// before. There are fewer tiers where bands are too few to cut between, and none for codings other
/// than adaptive.
std::vector<std::byte> with_tiers(std::span<const std::byte> mcpr, int tiers,
                                  const MeasureTier& measure);

/// The file that with_tiers() was given.
std::vector<std::byte> without_tiers(std::span<const std::byte> mcpr);

/// A file without tiers whose motion is that of the first tiers, with all other sections but ENDS.
/// The file that is read may end after them. Throws FormatError, also if it has fewer tiers.
std::vector<std::byte> file_of_tiers(std::span<const std::byte> mcpr, int tiers);

/// TIER as a packed bank has it: without the places where tiers end in a file.
std::vector<std::byte> packed_tiers(std::span<const std::byte> payload);

/// TIER of a file from that of a packed bank. `base` are the bytes of the sections between TIER and
/// the first FINE, `fine` those of each FINE's payload.
std::vector<std::byte> placed_tiers(std::span<const std::byte> packed, std::size_t base,
                                    const std::vector<std::size_t>& fine);

}  // namespace mocapress
