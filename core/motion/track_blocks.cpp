// SPDX-License-Identifier: MIT
#include "core/motion/track_blocks.h"

#include <algorithm>

namespace mocapress {

void visit_tracks(const Skeleton& skeleton, const Clip& clip, const TrackBlock& visit) {
  constexpr int kBlock = 8192;
  if (clip.frames() <= kBlock) return visit(0, body_tracks(skeleton, clip));
  for (int first = 0; first < clip.frames(); first += kBlock) {
    const int count = std::min(kBlock, clip.frames() - first);
    visit(first,
          body_tracks(skeleton, Clip{clip.sample_rate_hz, clip.channels.middleRows(first, count)}));
  }
}

}  // namespace mocapress
