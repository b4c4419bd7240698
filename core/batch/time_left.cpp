// SPDX-License-Identifier: MIT
#include "core/batch/time_left.h"

#include <algorithm>

namespace mocapress {

void TimeLeft::update(const BatchCounts& counts, double elapsed_seconds) {
  const bool has_ended = counts.done != done_;
  done_ = counts.done;
  if (counts.done == counts.kept) {
    seconds_.reset();
    return;
  }
  const double done = static_cast<double>(counts.bytes_done) + counts.bytes_under_way;
  const double worked = done - static_cast<double>(counts.bytes_kept);
  if (!(worked > 0)) return;  // files without a byte
  const double now = elapsed_seconds * (static_cast<double>(counts.bytes) - done) / worked;
  seconds_ = has_ended || !seconds_ ? now : std::min(*seconds_, now);
}

}  // namespace mocapress
