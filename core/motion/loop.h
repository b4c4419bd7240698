// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "core/motion/clip.h"

namespace mocapress {

/// How a clip goes on after its last frame when it is played again and again. The values are part
/// of the file format.
enum class Loop : std::uint8_t {
  None = 0,
  Repeats = 1,  // the last frame shows the first one's pose again: a turn takes frames - 1
  Follows = 2,  // the first frame follows upon the last: a turn takes frames
};

/// "none", "repeats", "follows".
std::string_view name(Loop loop);

/// Whether the clip is a loop. Its first and last pose must be alike: their difference is at most
/// half of what the clip usually moves in a frame. The difference of their velocities may be that
/// and what velocities change in a frame. Where the root stands and heads may differ.
Loop find_loop(const Motion& motion);

/// The same where its landmark_tracks() are there.
Loop find_loop(const Motion& motion, const Eigen::MatrixXd& tracks);

}  // namespace mocapress
