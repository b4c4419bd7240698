// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 7, which wishes
// for level-of-detail streaming. Tiers of a .mcpr file: FORMAT.md, "TIER".
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

/// Restores the file that with_tiers() was given.
std::vector<std::byte> without_tiers(std::span<const std::byte> mcpr);

/// Returns a file without tiers that has the motion of the first `tiers` tiers, and all other
/// sections. ENDS is left out if finer tiers are. `mcpr` may end after these tiers. Throws
/// FormatError, also if `mcpr` has fewer tiers.
std::vector<std::byte> file_of_tiers(std::span<const std::byte> mcpr, int tiers);

/// Size and checksum of the bytes that a tier adds to a file, as stored in TIER.
struct TierBytes {
  std::size_t size = 0;
  std::uint32_t checksum = 0;
};

TierBytes tier_bytes(std::span<const std::byte> piece);

/// The payload of TIER for a file or, if `bytes` is empty, for a packed bank.
std::vector<std::byte> write_tiers(const runtime::TierTable& tiers,
                                   const std::vector<TierBytes>& bytes = {});

}  // namespace mocapress
