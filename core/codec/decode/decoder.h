// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "core/codec/format/compressed_clip.h"

namespace mocapress {

/// The motion of a compressed clip, in the channels of its skeleton. Throws FormatError when its
/// bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// A compressed clip, or some frames of it, before its correction: in the channels that are coded.
struct Uncorrected {
  Clip clip;
  Eigen::MatrixXd differences;  // frames x 3 * effectors, cm: what the effectors lack
};

/// decode() without the correction.
Uncorrected decode_uncorrected(const CompressedClip& compressed);

/// From what visit_decoded() gives to what decode() does, but in the channels that are coded.
class Finish {
 public:
  /// The compressed clip must outlive this.
  explicit Finish(const CompressedClip& compressed);

  /// Frames from first_frame on: first the correction, if there is one, then the ends.
  CorrectionReport operator()(int first_frame, Uncorrected& block) const;

  /// Frames (rows) from first_frame on; nothing where ends are not coded.
  void add_ends(int first_frame, Eigen::MatrixXd& channels) const;

 private:
  const CompressedClip& compressed_;
  Skeleton coded_skeleton_;
  std::optional<EndPoses> ends_;
};

/// What a step of each signal is worth in the first and in the last segment. Of Coding::Adaptive.
std::pair<std::vector<float>, std::vector<float>> steps_at_ends(const CompressedClip& compressed);

/// The frames from first_frame on, which may be changed or taken.
using DecodedBlock = std::function<void(int first_frame, Uncorrected& block)>;

/// What the coefficients say, in time, segment after segment, so that they are never all in memory:
/// without correction and ends. A clip that is not in segments comes at once.
void visit_decoded(const CompressedClip& compressed, const DecodedBlock& visit);

/// A clip in the channels that are coded, in those of the skeleton.
Clip in_source_channels(const CompressedClip& compressed, Clip coded);

/// Puts some rows where they belong in a matrix of so many.
void put_rows(Eigen::MatrixXd rows, int first, int all, Eigen::MatrixXd& matrix);

}  // namespace mocapress
