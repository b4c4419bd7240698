// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace mocapress {

/// First and last frame of a part of a clip.
using FrameRange = std::pair<int, int>;

/// The visible part of a clip.
struct FrameWindow {
  double first = 0;
  double length = 0;  // frames; 0: all of the clip

  bool operator==(const FrameWindow&) const = default;
};

/// Maps a clip's frames to pixels. All strips share it, so that a frame has the same x in each.
struct TimeAxis {
  double left = 0;
  double right = 1;
  int frames = 0;
  FrameWindow window;

  double length() const { return window.length > 0 ? window.length : std::max(frames, 1); }

  /// The left edge of a frame. Its right edge is the left edge of the next frame.
  double xOf(double frame) const {
    return left + (right - left) * (frame - window.first) / length();
  }

  /// The frame at x, clamped to the clip.
  int frameAt(double x) const {
    const double share = (x - left) / std::max(right - left, 1.0);
    return std::clamp(static_cast<int>(std::floor(window.first + share * length())), 0,
                      std::max(frames - 1, 0));
  }
};

/// Margin in pixels at both ends of a strip.
inline constexpr int kStripMargin = 8;

}  // namespace mocapress
