// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "core/motion/clip.h"

namespace mocapress {

/// The continuation after a clip's last frame when it plays as a loop. The values are part of the
/// file format.
enum class Loop : std::uint8_t {
  None = 0,
  Repeats = 1,  // the last frame shows the first pose again: one round takes frames - 1 steps
  Follows = 2,  // the first frame follows the last: one round takes as many steps as frames
};

/// "none", "repeats", "follows".
std::string_view name(Loop loop);

/// Finds whether the clip is a loop, and of which kind. The first pose must be like the last or, if
/// it follows the last, like the pose that would come next: it may differ by at most half of what
/// the clip usually moves in a frame. The velocities at both ends may differ by as much, plus a few
/// times the usual change of velocity. The root may end elsewhere and face another direction.
Loop find_loop(const Motion& motion);

/// find_loop() where landmark_tracks() are already computed.
Loop find_loop(const Motion& motion, const Eigen::MatrixXd& tracks);

}  // namespace mocapress
