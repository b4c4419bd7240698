// SPDX-License-Identifier: MIT
// What ErrorBound does to one point after another, frame by frame.
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Three columns of numbers, of x, y and z, each from the first frame that is looked at on.
template <typename Number>
struct Columns3 {
  Number* x;
  Eigen::Index stride;  // to y, and from there to z
};

/// A point that a channel moves, cm. By `turn` it goes sin(turn) along and (1 - cos(turn)) across.
struct MovedFrames {
  Columns3<double> error;
  Columns3<double> along;
  Columns3<double> across;  // x: null where the channel translates
  double* squared;          // of the error
};

/// How far the channel moves it: factors of along and across, of each frame.
struct MovingSteps {
  const double* along;
  const double* across;
  Eigen::Index frames;
};

/// Whether a frame's squared error would be beyond its bound, and further than it is now.
bool goes_beyond(const MovedFrames& point, const MovingSteps& steps, const double* squared_bound);

/// Moves it: its error, and along and across with it.
void move_point(const MovedFrames& point, const MovingSteps& steps);

/// Where a turn about an axis through a joint takes a point: along = axis x (place - origin), and
/// across = axis x along. The place is the original plus the error.
void find_way_of_turn(Columns3<const double> axis, Columns3<const double> origin,
                      Columns3<const double> original, Eigen::Index frames,
                      const MovedFrames& point);

}  // namespace mocapress
