// SPDX-License-Identifier: MIT
#include "core/codec/encode/original.h"

#include "core/codec/decode/decoder.h"
#include "core/codec/encode/segments.h"

namespace mocapress {

void Original::compare(int first_frame, const Skeleton& skeleton, const Clip& decoded,
                       const Visit& visit) const {
  visit_tracks(skeleton, decoded, [&](int first, const Eigen::MatrixXd& tracks) {
    const int from = first_frame + first;
    const auto count = static_cast<int>(tracks.rows());
    if (tracks_)
      visit(from, tracks_().middleRows(from, count), tracks);
    else
      visit(from, body_tracks(motion_.skeleton, frames_of(motion_, from, count).clip), tracks);
  });
}

void Original::compare(const CompressedClip& compressed, const Visit& visit) const {
  const Skeleton skeleton = compressed.coded_skeleton();
  const Finish finish(compressed);
  visit_decoded(compressed, [&](int first, Uncorrected& block) {
    finish(first, block);
    compare(first, skeleton, block.clip, visit);
  });
}

}  // namespace mocapress
