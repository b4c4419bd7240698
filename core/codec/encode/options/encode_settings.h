// SPDX-License-Identifier: MIT
// The settings of one encode of one clip. Settings (core/mocapress/settings.h) fit any clip and
// give joints by name; encode_settings() turns them into these.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/codec/encode/options/effort.h"
#include "core/codec/encode/options/importance.h"
#include "core/codec/encode/options/important_range.h"
#include "core/codec/encode/options/promises.h"
#include "core/codec/encode/options/target.h"
#include "core/codec/format/compressed_clip.h"
#include "core/feet/contact_spans.h"
#include "core/ik/correction_kind.h"
#include "core/metrics/sight_limits.h"
#include "core/motion/landmarks.h"
#include "core/motion/loop.h"

namespace mocapress {

/// Lengths of segments. Encoding a segment takes about 150 bytes of memory for each channel and
/// frame.
struct SegmentPlan {
  int longest = 12288;  // frames, at least 256; longer clips are cut into several segments
  int overlap = 48;     // frames that neighbours share, 1 at least
};

/// Joints that inverse kinematics moves to their original places during playback.
struct EncodeCorrection {
  std::vector<int> joints;      // effectors; empty: the feet
  std::optional<double> ratio;  // r_IK: coefficients of the differences / kept ones; unset: the
                                // encoder finds the split between motion and correction
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;
};

/// The defaults are those of Settings.
struct EncodeSettings {
  Method method = Method::ClosedLoop;
  Coding coding = Coding::Deflate;  // used by the paper's methods: see effective_coding()
  Basis basis = Basis::Cubic;
  Weighting weighting = Weighting::Surface;
  Target target{Target::Kind::Error, 0.5};  // cm
  std::uint64_t seed = 1;                   // for annealing; the same seed gives the same bytes
  Effort effort = Effort::Default;
  Importance importance;                       // used by annealing and the closed loop
  std::vector<ImportantRange> ranges;          // used by the closed loop
  Promises promises;                           // kept in addition to a target that is an error
  SightLimits limits;                          // thresholds of what people notice, and the distance
  std::optional<EncodeCorrection> correction;  // its size counts in ratio and size
  std::optional<std::vector<ContactSpan>> contacts;  // edited ones; unset: Encoder::contacts()
  SegmentPlan segments;                              // for a closed loop
  Ends ends = Ends::Even;                            // for a closed loop; size counts their bytes
  std::optional<Loop> loop;                          // unset: find_loop() decides
  bool figures_only = false;                         // leaves out the decoded clip: see Encoding

  /// A draft's size is estimated and its bytes are not made: see Encoding. Only for drafts of the
  /// closed loop in one segment without correction.
  bool size_will_do = false;
};

/// The coding that will be used. The closed loop always uses its own.
inline Coding effective_coding(const EncodeSettings& settings) {
  return settings.method == Method::ClosedLoop ? Coding::Adaptive : settings.coding;
}

}  // namespace mocapress
