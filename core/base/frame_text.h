// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace mocapress {

/// The number of a frame as people read and type it: in the studio, on pages, in sign-offs and on
/// the command line the first frame is 1. Code, JSON, CSV columns and links count from 0. Takes any
/// frame that a file may contain, even INT_MAX.
inline std::string frame_text(int frame) {
  return std::to_string(std::int64_t{frame} + 1);
}

}  // namespace mocapress
