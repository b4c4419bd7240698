// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// Where the frames of a clip are on a strip, in pixels: strips above each other share it, so that
/// a moment is in one line in all of them.
struct TimeAxis {
  double left = 0;
  double right = 1;
  int frames = 0;

  /// Where a frame begins; the next one's beginning is its end.
  double xOf(double frame) const { return left + (right - left) * frame / std::max(frames, 1); }

  /// The nearest frame of the clip.
  int frameAt(double x) const {
    const double share = (x - left) / std::max(right - left, 1.0);
    return std::clamp(static_cast<int>(std::floor(share * frames)), 0, std::max(frames - 1, 0));
  }
};

/// Free at both ends of a strip, pixels.
inline constexpr int kStripMargin = 8;

}  // namespace mocapress
