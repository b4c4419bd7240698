// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// The part of a clip that is in sight.
struct FrameWindow {
  double first = 0;
  double length = 0;  // frames; 0: all of the clip

  bool operator==(const FrameWindow&) const = default;
};

/// Where the frames of a clip are on a strip, in pixels: strips above each other share it, so that
/// a moment is in one line in all of them.
struct TimeAxis {
  double left = 0;
  double right = 1;
  int frames = 0;
  FrameWindow window;

  double length() const { return window.length > 0 ? window.length : std::max(frames, 1); }

  /// Where a frame begins; the next one's beginning is its end.
  double xOf(double frame) const {
    return left + (right - left) * (frame - window.first) / length();
  }

  /// The nearest frame of the clip.
  int frameAt(double x) const {
    const double share = (x - left) / std::max(right - left, 1.0);
    return std::clamp(static_cast<int>(std::floor(window.first + share * length())), 0,
                      std::max(frames - 1, 0));
  }
};

/// Free at both ends of a strip, pixels.
inline constexpr int kStripMargin = 8;

}  // namespace mocapress
