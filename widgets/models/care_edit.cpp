// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/care_edit.h"

#include <algorithm>

namespace mocapress {

std::vector<ImportantRange> withCareOver(const std::vector<ImportantRange>& ranges, int first_frame,
                                         int last_frame, double factor) {
  std::vector<ImportantRange> parts;
  if (factor != 1) parts.push_back({first_frame, last_frame, factor});
  for (const ImportantRange& range : ranges) {
    ImportantRange before = range;
    ImportantRange after = range;
    before.last_frame = std::min(range.last_frame, first_frame - 1);
    after.first_frame = std::max(range.first_frame, last_frame + 1);
    if (before.first_frame <= before.last_frame) parts.push_back(before);
    if (after.first_frame <= after.last_frame) parts.push_back(after);
  }
  std::sort(parts.begin(), parts.end(), [](const ImportantRange& a, const ImportantRange& b) {
    return a.first_frame < b.first_frame;
  });
  std::vector<ImportantRange> joined;
  for (const ImportantRange& part : parts) {
    if (!joined.empty() && joined.back().factor == part.factor &&
        joined.back().last_frame + 1 >= part.first_frame)
      joined.back().last_frame = std::max(joined.back().last_frame, part.last_frame);
    else
      joined.push_back(part);
  }
  return joined;
}

double careOver(const std::vector<ImportantRange>& ranges, int first_frame, int last_frame) {
  double factor = 1;
  for (const ImportantRange& range : ranges)
    if (range.first_frame <= first_frame && range.last_frame >= last_frame)
      factor = std::max(factor, range.factor);
  return factor;
}

}  // namespace mocapress
