// SPDX-License-Identifier: MIT
// The vectorised loops of ErrorBound. Each handles one point in many frames.
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Three columns of numbers (x, y, z), each starting at the first frame to handle.
template <typename Number>
struct Columns3 {
  Number* x;
  Eigen::Index stride;  // numbers from x to y, and from y to z
};

/// A point that a channel moves, in cm. A rotation by `turn` moves it by sin(turn) * along + (1 -
/// cos(turn)) * across.
struct MovedFrames {
  Columns3<double> error;
  Columns3<double> along;
  Columns3<double> across;  // x: null where the channel translates
  double* squared;          // squared length of `error`
};

/// A channel's movement: for each frame, the factors of MovedFrames::along and MovedFrames::across.
struct MovingSteps {
  const double* along;
  const double* across;
  Eigen::Index frames;
};

/// Returns whether any frame's squared error would exceed its bound and grow.
bool goes_beyond(const MovedFrames& point, const MovingSteps& steps, const double* squared_bound);

/// Moves the point: updates its error, and turns `along` and `across` with it.
void move_point(const MovedFrames& point, const MovingSteps& steps);

/// Finds the directions in which a turn about an axis through a joint moves a point: along = axis x
/// (place - origin), across = axis x along. The place is the original plus the error.
void find_way_of_turn(Columns3<const double> axis, Columns3<const double> origin,
                      Columns3<const double> original, Eigen::Index frames,
                      const MovedFrames& point);

}  // namespace mocapress
