// SPDX-License-Identifier: MIT
#include "core/codec/encode/segments.h"

#include <algorithm>

namespace mocapress {

SegmentLayout even_segments(int frames, const SegmentPlan& plan) {
  constexpr int kLeast = runtime::kLeastSegment;
  const int longest = std::max(plan.longest, kLeast);
  const int overlap = std::clamp(plan.overlap, 1, kLeast / 2);
  if (frames <= longest) return SegmentLayout::whole(frames);
  const int count = SegmentLayout{frames, longest, overlap}.count();
  const int length = (frames + (count - 1) * overlap + count - 1) / count;
  return {frames, std::max(length, kLeast), overlap};
}

Motion frames_of(const Motion& motion, int first, int count) {
  return {motion.skeleton,
          {motion.clip.sample_rate_hz, motion.clip.channels.middleRows(first, count)}};
}

std::vector<ContactSpan> frames_of(const std::vector<ContactSpan>& contacts, int first, int count) {
  std::vector<ContactSpan> inside;
  for (const ContactSpan& span : contacts)
    if (span.last_frame >= first && span.first_frame < first + count)
      inside.push_back({span.landmark, std::max(span.first_frame - first, 0),
                        std::min(span.last_frame - first, count - 1)});
  return inside;
}

}  // namespace mocapress
