// SPDX-License-Identifier: MIT
// Limits of a .mcpr file, shared by all readers and writers and stated in FORMAT.md, "Limits". They
// are also the default limits of the C interface, so that every valid file opens anywhere; an
// engine may set lower ones. The limits of a joint are in joint_model.h, beside the arrays that
// they size.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/joint_model.h"

namespace mocapress::runtime {

/// Joints on the longest path from a root down, both ends counted. This depth is safe for programs
/// that walk a BVH by recursion.
inline constexpr int kMostDepth = 1000;

inline constexpr std::uint32_t kMostChannels = kMostChannelsOfJoint * kMostJoints;

/// Most bytes of a name, whose length is stored in one byte.
inline constexpr std::size_t kMostNameBytes = 255;

/// Largest size of a joint in JNTS before coding: name, parent, offset, flags, axes, end site and
/// channels.
inline constexpr std::size_t kMostBytesOfJoint =
    (1 + kMostNameBytes) + 2 + 3 * 4 + 1 + 4 * 4 + 3 * 4 + (1 + kMostChannelsOfJoint);

/// Most frames of a clip, almost ten hours at 120 Hz.
inline constexpr std::uint32_t kMostFrames = std::uint32_t{1} << 22;

/// Most scalar tracks of a clip. Faces have about a hundred.
inline constexpr std::uint32_t kMostTracks = 4096;

/// Most samples of a file, in all signals (channels and the offsets of IKCO) and curve tracks.
/// Frames that two segments share count twice. Enough for two and a half hours of 62 channels at
/// 120 Hz.
inline constexpr std::uint64_t kMostValues = std::uint64_t{1} << 26;

/// Upper bound for the number of values in a file. A still clip takes hardly any bytes, so the
/// first term is generous: half an hour of 62 channels at 120 Hz. The second term keeps a small
/// file from demanding much work. It counts the bytes of known sections only, because unknown ones
/// may hold anything.
constexpr std::uint64_t most_values_of(std::uint64_t known_bytes) {
  return (std::uint64_t{1} << 24) + (known_bytes << 14);
}

/// The most effectors, and the most angles, that one limb may have.
inline constexpr int kMostEffectorsOfLimb = 8;
inline constexpr int kMostAngles = 64;

/// The most joints between the root and the effectors of one limb. Every step of a solver visits
/// them.
inline constexpr int kMostLinks = 256;

// Memory. A value takes four bytes decoded, and at most about as many in the file or in the
// resident form. kMemoryBesideValues is for the skeleton, contexts and indices.
inline constexpr std::size_t kMemoryBesideValues = std::size_t{16} << 20;

/// Memory for the state of the predictions, 2.6 KB per signal.
inline constexpr std::size_t kMemoryOfSignals = std::size_t{80} << 20;

/// Most scratch memory for reading: the decoded values of one segment, possibly the whole clip; the
/// coded motion of all segments; and the state of the predictions.
inline constexpr std::size_t kMostScratchBytes =
    8 * kMostValues + kMemoryOfSignals + kMemoryBesideValues;

inline constexpr std::size_t kMostResidentBytes = 4 * kMostValues + kMemoryBesideValues;

}  // namespace mocapress::runtime
