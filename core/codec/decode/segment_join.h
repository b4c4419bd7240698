// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/codec/format/segment_layout.h"

namespace mocapress {

using runtime::SegmentLayout;

/// Joins the samples of segments (frames x signals, as decode_signals() gives them), one after the
/// other, blended where two overlap. Of those before only what is shared is kept.
class SegmentJoin {
 public:
  explicit SegmentJoin(const SegmentLayout& layout) : layout_(layout) {}

  /// Those of the next segment: gives the frames from its first on that no later one shares.
  Eigen::MatrixXd next(Eigen::MatrixXd samples);

 private:
  SegmentLayout layout_;
  int segment_ = 0;
  Eigen::MatrixXd shared_;  // the last frames of the segment before
};

}  // namespace mocapress
