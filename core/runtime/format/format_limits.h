// SPDX-License-Identifier: MIT
// What a .mcpr file may hold: one set of limits for everyone who writes or reads one, stated in
// FORMAT.md, "Limits". The default limits of the C interface are these, so that whatever was
// written opens anywhere; an engine that knows its clips may ask for less. Those of a joint
// stand beside the arrays they size: joint_model.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/joint_model.h"

namespace mocapress::runtime {

/// Joints from a root down, both ends counted: what a BVH can nest and still be read by programs
/// that walk it by calling themselves.
inline constexpr int kMostDepth = 1000;

inline constexpr std::uint32_t kMostChannels = kMostChannelsOfJoint * kMostJoints;

/// A name's length is a byte.
inline constexpr std::size_t kMostNameBytes = 255;

/// Of a joint in JNTS, before it is coded: its name, parent, offset, flags, axes, end site and
/// channels.
inline constexpr std::size_t kMostBytesOfJoint =
    (1 + kMostNameBytes) + 2 + 3 * 4 + 1 + 4 * 4 + 3 * 4 + (1 + kMostChannelsOfJoint);

/// Ten hours at 120 Hz.
inline constexpr std::uint32_t kMostFrames = std::uint32_t{1} << 22;

/// Scalar tracks: faces have some hundred.
inline constexpr std::uint32_t kMostTracks = 4096;

/// Samples of all signals (channels and IKCO's), frames that two segments share counted twice, and
/// of curves of tracks: two hours and a half of 62 channels at 120 Hz.
inline constexpr std::uint64_t kMostValues = std::uint64_t{1} << 26;

/// A still clip takes next to no bytes, but what a file of so many bytes may keep a reader busy
/// with grows with them.
constexpr std::uint64_t most_values_of(std::uint64_t file_bytes) {
  return (std::uint64_t{1} << 22) + (file_bytes << 15);
}

/// A solver has room for so many effectors and angles of one limb.
inline constexpr int kMostEffectorsOfLimb = 8;
inline constexpr int kMostAngles = 64;

/// Joints from the root to the effectors of a limb: each step of a solver walks them.
inline constexpr int kMostLinks = 256;

// Memory. A value takes four bytes decoded, at most about as many coded or in the resident form;
// the rest is for the skeleton, contexts and indices.
inline constexpr std::size_t kMemoryBesideValues = std::size_t{16} << 20;

/// What the prediction learns of signals, 2.6 KB each.
inline constexpr std::size_t kMemoryOfSignals = std::size_t{80} << 20;

/// Of reading: the values of a segment, which may be all, the coded motion of all segments, and
/// what is learned of signals.
inline constexpr std::size_t kMostScratchBytes =
    8 * kMostValues + kMemoryOfSignals + kMemoryBesideValues;

inline constexpr std::size_t kMostResidentBytes = 4 * kMostValues + kMemoryBesideValues;

}  // namespace mocapress::runtime
