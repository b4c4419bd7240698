// SPDX-License-Identifier: MIT
#include "core/codec/segments.h"

#include <algorithm>

namespace mocapress {

SegmentLayout even_segments(int frames, const SegmentPlan& plan) {
  constexpr int kLeast = decoder::kLeastSegment;
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

void lay_over(const Eigen::MatrixXd& segment_samples, const SegmentLayout& layout, int segment,
              Eigen::MatrixXd& samples) {
  const int first = layout.first(segment);
  const int shared = segment == 0 ? 0 : layout.overlap;
  for (int i = 0; i < shared; ++i) {
    const float share = decoder::share_of_later(layout, i);
    for (Eigen::Index s = 0; s < samples.cols(); ++s) {
      double& sample = samples(first + i, s);
      sample = static_cast<double>(decoder::blended(
          static_cast<float>(sample), static_cast<float>(segment_samples(i, s)), share));
    }
  }
  const Eigen::Index alone = segment_samples.rows() - shared;
  samples.middleRows(first + shared, alone) = segment_samples.bottomRows(alone);
}

}  // namespace mocapress
