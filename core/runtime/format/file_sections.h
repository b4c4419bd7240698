// SPDX-License-Identifier: MIT
// The container of a .mcpr file, version 1: FORMAT.md. Every reader starts here.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/packed_clip.h"
#include "core/runtime/format/result.h"
#include "core/runtime/format/section.h"
#include "core/runtime/format/segment_layout.h"
#include "core/runtime/format/tiers.h"

namespace mocapress::runtime {

/// The head of section trks.
struct TracksHead {
  std::uint32_t tracks = 0;  // 0: the clip has none
  std::uint32_t curves = 0;  // tracks coded as curves; the others are held (piecewise constant)
  Wavelet wavelet = Wavelet::Cubic;
  std::uint32_t record_bytes = 0;  // size of the decoded records
  std::uint32_t runs = 0;          // total number of runs of the held tracks
  Bytes stream;                    // coded curves
  Bytes bits;                      // coded records and runs
  std::size_t bytes = 0;           // size of the section with its head
  Bytes payload;                   // payload of the section, all of it
};

/// The contents of all sections, checked against the limits but not decoded yet.
struct FileSections {
  double sample_rate = 0;  // Hz
  std::uint32_t frames = 0;
  Wavelet wavelet = Wavelet::Cubic;
  std::uint8_t coding = 0;  // coding in CLIP: kComparison ... kAdaptive
  std::uint8_t method = 0;  // this and the next four are from CLIP
  std::uint8_t weighting = 0;
  std::uint64_t seed = 0;
  float eps_cm = 0;
  float max_error_cm = 0;
  std::uint32_t joints = 0;       // number stated by JNTS
  std::uint32_t channels = 0;     // number stated by JNTS
  std::uint32_t joint_bytes = 0;  // size of the decoded skeleton
  Bytes coded_joints;             // the skeleton as the range coder wrote it
  Bytes joint_orders;             // packed clips only: joint_orders.h
  Bytes learned;                  // PRIO, packed clips only: learned_priors.h
  Bytes motion;                   // payload of MOTN or COMP; the first tier, if there are several
  TierTable tiers;                // from TIER
  int tiers_read = 0;  // number of tiers read: MOTN, and pieces behind the sections; 0 in a file
                       // without tiers
  Bytes fine[kMostTiers - 1];      // pieces that the finer tiers add to MOTN
  SegmentLayout segments;          // from SEGS; one segment without it
  Bytes segment_sizes;             // u32 sizes of the segments in MOTN, then in each finer tier
  std::size_t segments_bytes = 0;  // size of SEGS
  std::size_t correction_bytes = 0;
  std::size_t ends_bytes = 0;  // size of ENDS; 0: there is none
  LoopKind loop = LoopKind::None;
  EndReaches end_reaches;
  std::int8_t end_step_exponent[kMostEnds] = {};
  Bytes coded_ends;
  Solver solver = Solver::NearestPose;
  std::uint32_t effectors = 0;
  struct Effector {
    std::uint16_t joint;
    std::uint16_t top;
  } effector[kMostEffectors] = {};
  std::size_t effector_offset = 0;  // offset of the first effector in the file
  Bytes axes;                       // payload of AXES
  Bytes orders;                     // payload of ordr
  Bytes source;                     // payload of srce
  TracksHead tracks;                // head of trks

  bool is_adaptive() const { return coding == kAdaptive; }

  std::uint32_t signal_count() const { return channels + 3 * effectors; }

  /// Values to decode: the samples of all segments and tracks.
  std::uint64_t value_count() const {
    return static_cast<std::uint64_t>(segments.coded_frames()) * signal_count() + track_values();
  }

  /// Number of values that is bounded by the size of the file. A clip without signals counts as if
  /// it had one.
  std::uint64_t room_values() const {
    return static_cast<std::uint64_t>(segments.coded_frames()) * std::max(signal_count(), 1U) +
           track_values();
  }

  /// Number of samples in curves, plus two values per run.
  std::uint64_t track_values() const {
    return std::uint64_t{tracks.curves} * frames + std::uint64_t{2} * tracks.runs;
  }

  /// Number of bytes in the file that code the motion.
  std::size_t motion_bytes() const {
    return coded_size() + segments_bytes + correction_bytes + ends_bytes + axes.size;
  }

  /// Number of pieces that the coefficients are in: in a file with tiers, MOTN and the pieces
  /// behind all sections that were read; else one.
  int pieces() const { return std::max(tiers_read, 1); }
  const Bytes& piece(int p) const { return p == 0 ? motion : fine[p - 1]; }

  /// Size of the coefficients of all segments, in all pieces that were read.
  std::size_t coded_size() const {
    std::size_t size = 0;
    for (int p = 0; p < pieces(); ++p) size += piece(p).size;
    return size;
  }

  /// Size of a segment's coefficients: in one piece, or in all pieces that were read.
  std::uint32_t segment_size(int piece, int segment) const;
  std::uint32_t segment_size(int segment) const;

  /// Position in the file of a byte of a segment's coefficients. These may lie in several pieces.
  std::size_t offset_of(int segment, std::size_t byte) const;

  /// Copies the coefficients of all segments, one segment after the other: coded_size() bytes.
  void copy_coded(std::uint8_t* out) const;

  /// Number of the finest bands that are missing, because their tiers were not read; 0 in a file
  /// without tiers.
  int bands_left_out() const {
    return tiers_read == 0 ? 0 : tiers.tier[tiers_read - 1].bands_left_out;
  }
};

/// Parses and checks the payload of ENDS, except for its coded part. `sections.frames` must be set.
mcpr_result read_ends(const Bytes& payload, FileSections& sections);

/// Returns the limits that a caller gave, or the default ones if the pointer is null.
inline mcpr_limits or_default(const mcpr_limits* limits) {
  if (limits != nullptr) return *limits;
  mcpr_limits all;
  mcpr_default_limits(&all);
  return all;
}

/// Reads and checks all sections of a file.
mcpr_result read_sections(const void* file, std::size_t size, const mcpr_limits& limits,
                          FileSections& sections);

/// Reads and checks all sections of a clip in a packed bank.
mcpr_result read_sections(const mcpk_bank& bank, const BankEntry& entry, const mcpr_limits& limits,
                          FileSections& sections);

}  // namespace mocapress::runtime
