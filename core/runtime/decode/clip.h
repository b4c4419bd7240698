// SPDX-License-Identifier: MIT
// The resident form of a clip, which mcpr_clip points to: a skeleton, limbs for the IK solver,
// tracks and signals, in one block of bytes without pointers.
#pragma once

#include "core/runtime/decode/resident_signals.h"
#include "core/runtime/decode/track_block.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/place_in_clip.h"
#include "core/runtime/format/segment_layout.h"
#include "core/runtime/ik/limb.h"
#include "core/runtime/ik/solve.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// A LimbPlan (ik/limb.h) as it is stored in the block.
struct ResidentLimb {
  std::uint16_t effectors;
  std::uint16_t links;
  std::uint16_t turns;
  std::uint16_t is_two_bones;
  std::uint32_t effector_numbers;  // this and the next three are offsets from the clip
  std::uint32_t effector_links;
  std::uint32_t link;
  std::uint32_t turn;
};

/// The head of the block. Everything after it is found by offsets from here.
struct ClipBlock {
  static constexpr std::uint32_t kMark = 0x7263704D;  // first bytes of a clip, which tell it from
                                                      // other memory
  std::uint32_t mark = kMark;
  std::uint32_t joint_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t effector_count = 0;
  double sample_rate = 0;  // Hz
  std::uint64_t total_bytes = 0;
  std::uint64_t skeleton_bytes = 0;
  Solver solver = Solver::NearestPose;
  std::uint32_t solver_iterations = 0;  // maximum, per limb and frame
  std::uint16_t limb_count = 0;
  std::uint16_t most_links = 0;  // the largest number of links in a limb
  LoopKind loop = LoopKind::None;
  EndReaches end_reaches;
  std::uint32_t joints = 0;  // this and the following are offsets from the clip, in bytes
  std::uint32_t names = 0;
  std::uint32_t limbs = 0;
  std::uint32_t ends = 0;  // values of the end corrections: a row of channels for each correction
  std::uint32_t motions = 0;  // offsets of the segments' signals
  std::uint32_t tracks = 0;   // mcpr_tracks; 0: the clip has none
  SegmentLayout segments;
  SignalsShape largest;  // largest values of all segments, for work space that fits each

  template <typename T>
  const T* at(std::uint32_t offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + offset);
  }
  const mcpr_tracks* scalar_tracks() const {
    return tracks == 0 ? nullptr : at<mcpr_tracks>(tracks);
  }
  const JointModel* joint_models() const { return at<JointModel>(joints); }
  const float* end_values(int end) const {
    return at<float>(ends) + static_cast<std::size_t>(end) * channel_count;
  }
  const ResidentSignals& motion(int segment) const {
    return *at<ResidentSignals>(at<std::uint32_t>(motions)[segment]);
  }
  /// Number of frames in one cycle of a loop; 0 if the clip is not a loop.
  int turn_frames() const { return turn_frames_of(segments.frames, loop); }
  LimbPlan limb(int l) const {
    const ResidentLimb& limb = at<ResidentLimb>(limbs)[l];
    return {.effectors = limb.effectors,
            .links = limb.links,
            .turns = limb.turns,
            .is_two_bones = limb.is_two_bones != 0,
            .effector_numbers = at<std::uint16_t>(limb.effector_numbers),
            .effector_links = at<std::uint16_t>(limb.effector_links),
            .link = at<LimbLink>(limb.link),
            .turn = at<LimbTurn>(limb.turn)};
  }
};

}  // namespace mocapress::runtime

struct mcpr_clip {
  mocapress::runtime::ClipBlock block;
};
