// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/important_range.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/frame_text.h"
#include "core/base/number_text.h"

namespace mocapress {

Eigen::VectorXd frame_factors(const std::vector<ImportantRange>& ranges, int frames) {
  if (ranges.empty()) return {};
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(frames);
  for (const auto& [first, last, factor] : ranges) {
    if (!(factor >= 1 && factor <= kMostRangeFactor))
      throw Error("the importance of frames " + frame_text(first) + " to " + frame_text(last) +
                  " is not a number from 1 to " + shortest_text(kMostRangeFactor));
    if (first < 0 || last < first || last >= frames)
      throw Error("frames " + frame_text(first) + " to " + frame_text(last) +
                  " are not a range of the clip, which has " + std::to_string(frames) + " frames");
    auto of_range = factors.segment(first, last - first + 1);
    of_range = of_range.cwiseMax(factor).eval();
  }
  return factors;
}

std::vector<ImportantRange> frames_of(const std::vector<ImportantRange>& ranges, int first,
                                      int count) {
  std::vector<ImportantRange> within;
  for (ImportantRange range : ranges) {
    range.first_frame = std::max(range.first_frame - first, 0);
    range.last_frame = std::min(range.last_frame - first, count - 1);
    if (range.first_frame <= range.last_frame) within.push_back(range);
  }
  return within;
}

}  // namespace mocapress
