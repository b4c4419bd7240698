// SPDX-License-Identifier: MIT
// Makes a clip from the bytes of a file, in two steps: read() decodes everything into scratch
// memory, then build() makes the resident form from the decoded data. For a segmented clip, scratch
// memory holds one decoded segment and the coded bytes of all segments. So each segment is decoded
// twice: read() checks and measures it, build() stores it.
#pragma once

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/track_loader.h"
#include "core/runtime/format/coefficient_coder.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/file_sections.h"
#include "core/runtime/format/joint_bytes.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/signal_neighbours.h"
#include "core/runtime/ik/limb_planner.h"

namespace mocapress::runtime {

/// The scratch memory of mcpr_read: decoded data, and work space.
class FileLoader {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  FileLoader(Memory& memory, const FileSections& sections);

  /// Decodes the skeleton, the IK correction, the tracks and the motion.
  mcpr_result read();

  /// Size of the clip that build() makes.
  std::uint64_t resident_size();

  /// Builds the clip in zeroed memory.
  const mcpr_clip* build(std::byte* memory);

  static constexpr std::uint32_t kMark = 0x6465704FU;  // set when read() has succeeded
  std::uint32_t mark = 0;

  std::uint32_t solver_iterations = kMostSweeps;  // upper limit for the clip's IK iterations, from
                                                  // mcpr_limits

 private:
  mcpr_result read_joints();
  mcpr_result order_angles_of_joints();
  mcpr_result turn_axes_of_joints();
  mcpr_result plan_limbs();
  mcpr_result read_tracks() { return tracks_.read(); }
  mcpr_result read_motion();
  std::uint64_t lay_out(std::byte* memory);
  void lay_out_motion(BlockLayout& block, ClipBlock& head, std::byte* memory);
  mcpr_result read_segment(int segment);
  mcpr_result decode_segment(int segment, const Bytes& coded);
  void find_double_precision_limits();
  void read_ends(EndReader& ends, int pose);
  void read_end(EndReader& ends, int end);
  QuantisedSource source(int segment) const;

  FileSections sections_;
  std::uint8_t* joint_bytes_;
  JointModel* joints_;
  std::int16_t* parents_;
  std::uint8_t* channel_counts_;
  std::uint16_t* depths_;  // number of joints from a root down to each joint, both counted
  std::uint32_t name_bytes_ = 0;
  SignalNeighbours* neighbours_;
  AdaptiveBit* contexts_;
  std::uint8_t* coded_motion_;  // the coefficients of all segments; empty if one segment in one
                                // piece is read in place
  struct Segment {
    std::size_t first_byte;  // position of the segment in the coefficients of all segments
    std::size_t bytes;
    std::uint64_t resident_bytes;
  };
  Segment* segments_;
  int decoded_ = -1;  // number of the segment that the next three members hold; -1: none
  std::int32_t* step_exponents_;
  std::int32_t* values_;
  float* steps_;
  float* double_precision_limits_;
  float* reach_;  // for each joint: distance of the furthest joint or end site below it
  float* ends_;  // end corrections: a row of channels for each, in the order first pose, last pose,
                 // velocity; null: none
  std::uint8_t* notes_;
  JointByteCoder joint_coder_;
  NeighbourFinder neighbour_finder_;
  CoderNotes coder_notes_;
  LimbPlanner limb_planner_;
  TrackLoader tracks_;
  EffectorEnds effectors_[kMostEffectors];
};

/// Finds the scratch memory for reading a file. Fails if the file is not coded adaptively, or if
/// the memory exceeds the limits.
mcpr_result find_read_bytes(const FileSections& sections, const mcpr_limits& limits,
                            std::uint64_t& bytes);

mcpr_info info_of(const FileSections& sections, std::uint64_t read_bytes);

/// Implements mcpr_read() for sections that need `read_bytes` of scratch memory.
mcpr_result read_into(const FileSections& sections, std::uint64_t read_bytes,
                      const mcpr_limits& limits, void* scratch, std::size_t scratch_size,
                      std::size_t& resident_bytes);

}  // namespace mocapress::runtime
