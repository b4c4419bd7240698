// SPDX-License-Identifier: MIT
// The container of a .mcpr file, version 1: FORMAT.md. Every reader of one begins here.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/packed_clip.h"
#include "core/runtime/format/result.h"
#include "core/runtime/format/section.h"
#include "core/runtime/format/segment_layout.h"

namespace mocapress::runtime {

/// What trks says before anything is decoded.
struct TracksHead {
  std::uint32_t tracks = 0;  // 0: there are none
  std::uint32_t curves = 0;  // of them: the others are held
  Wavelet wavelet = Wavelet::Cubic;
  std::uint32_t record_bytes = 0;  // decoded
  std::uint32_t runs = 0;          // of what is held
  Bytes stream;                    // of the curves
  Bytes bits;                      // of records and runs
  std::size_t bytes = 0;           // of the section, its head and all
};

/// What the sections say before anything is decoded, all of it checked against the limits.
struct FileSections {
  double sample_rate = 0;  // Hz
  std::uint32_t frames = 0;
  Wavelet wavelet = Wavelet::Cubic;
  std::uint8_t coding = 0;  // of CLIP: kComparison ... kAdaptive
  std::uint8_t method = 0;  // of CLIP, as are the next four
  std::uint8_t weighting = 0;
  std::uint64_t seed = 0;
  float eps_cm = 0;
  float max_error_cm = 0;
  std::uint32_t joints = 0;        // as JNTS promises
  std::uint32_t channels = 0;      // as JNTS promises
  std::uint32_t joint_bytes = 0;   // of the skeleton, decoded
  Bytes coded_joints;              // what a range coder made of them
  Bytes joint_orders;              // of a packed clip: joint_orders.h
  Bytes learned;                   // PRIO of a packed clip: learned_priors.h
  Bytes motion;                    // MOTN, or COMP
  SegmentLayout segments;          // SEGS, or one
  Bytes segment_sizes;             // u32 of each in MOTN; none where there is no SEGS
  std::size_t segments_bytes = 0;  // of SEGS
  std::size_t correction_bytes = 0;
  std::size_t ends_bytes = 0;  // of ENDS; 0: none
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
  std::size_t effector_offset = 0;  // of the first
  Bytes axes;                       // AXES
  Bytes orders;                     // ordr
  Bytes source;                     // srce
  TracksHead tracks;                // trks

  bool is_adaptive() const { return coding == kAdaptive; }

  std::uint32_t signal_count() const { return channels + 3 * effectors; }

  /// Of all segments, and of tracks.
  std::uint64_t value_count() const {
    return static_cast<std::uint64_t>(segments.coded_frames()) * signal_count() + track_values();
  }

  /// What the length of the file has to allow: a clip without signals counts as one.
  std::uint64_t room_values() const {
    return static_cast<std::uint64_t>(segments.coded_frames()) * std::max(signal_count(), 1U) +
           track_values();
  }

  /// Samples of curves, and two for each run.
  std::uint64_t track_values() const {
    return std::uint64_t{tracks.curves} * frames + std::uint64_t{2} * tracks.runs;
  }

  /// What the file has of the motion.
  std::size_t motion_bytes() const {
    return motion.size + segments_bytes + correction_bytes + ends_bytes + axes.size;
  }

  /// Of a segment in MOTN.
  std::uint32_t segment_size(int segment) const;
};

/// Reads and checks the payload of ENDS of a clip whose frames are known, but for what is coded.
mcpr_result read_ends(const Bytes& payload, FileSections& sections);

/// Reads and checks all sections.
mcpr_result read_sections(const void* file, std::size_t size, const mcpr_limits& limits,
                          FileSections& sections);

/// The same of a clip of a packed bank.
mcpr_result read_sections(const mcpk_bank& bank, const BankEntry& entry, const mcpr_limits& limits,
                          FileSections& sections);

}  // namespace mocapress::runtime
