// SPDX-License-Identifier: MIT
#include "core/codec/decode/segment_join.h"

namespace mocapress {

Eigen::MatrixXd SegmentJoin::next(Eigen::MatrixXd samples) {
  for (Eigen::Index i = 0; i < shared_.rows(); ++i) {
    const float share = runtime::share_of_later(layout_, static_cast<int>(i));
    for (Eigen::Index s = 0; s < samples.cols(); ++s)
      samples(i, s) = static_cast<double>(runtime::blended(
          static_cast<float>(shared_(i, s)), static_cast<float>(samples(i, s)), share));
  }
  if (++segment_ == layout_.count()) return samples;
  shared_ = samples.bottomRows(layout_.overlap);
  return samples.topRows(layout_.hop());
}

}  // namespace mocapress
