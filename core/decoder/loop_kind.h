// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace mocapress::decoder {

/// How a clip goes on after its last frame: FORMAT.md, loop.
enum class LoopKind : std::uint8_t {
  None = 0,
  Repeats = 1,  // the last frame shows the first one's pose again
  Follows = 2,  // the first frame follows upon the last
};

}  // namespace mocapress::decoder
