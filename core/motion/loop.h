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

/// True if the clip is a loop. Its first and last pose must be alike: they differ by at most half
/// of what the clip usually moves in a frame. Their velocities may differ by as much, plus the
/// usual change of velocity in a frame. The root may stand and head elsewhere.
Loop find_loop(const Motion& motion);

/// find_loop() where landmark_tracks() are already computed.
Loop find_loop(const Motion& motion, const Eigen::MatrixXd& tracks);

}  // namespace mocapress
