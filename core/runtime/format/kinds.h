// SPDX-License-Identifier: MIT
// What single bytes of the format stand for: FORMAT.md.
#pragma once

#include <cstdint>

namespace mocapress::runtime {

/// How an odd sample is predicted.
enum class Wavelet : std::uint8_t { Haar = 0, Linear = 1, Cubic = 2 };

/// How a clip goes on after its last frame: FORMAT.md, loop.
enum class LoopKind : std::uint8_t {
  None = 0,
  Repeats = 1,  // the last frame shows the first one's pose again
  Follows = 2,  // the first frame follows upon the last
};

/// Codings of the motion that mean something to a reader.
inline constexpr std::uint8_t kComparison = 0;  // of a comparison method: no wavelets
inline constexpr std::uint8_t kAdaptive = 3;

/// Who solves for the effectors of a correction.
enum class Solver : std::uint8_t {
  CyclicDescent = 1,  // the paper's: one joint after the other, over and over
  NearestPose = 2,    // what moves the limb least: two bones in closed form, else damped steps
};

inline constexpr int kMostEffectors = 32;

}  // namespace mocapress::runtime
