// SPDX-License-Identifier: MIT
// Enumerations stored as single bytes in the format: FORMAT.md.
#pragma once

#include <cstdint>

namespace mocapress::runtime {

/// The interpolating wavelet bases. They differ in the even samples that predict an odd one.
enum class Wavelet : std::uint8_t {
  Haar = 0,    // 1 neighbour, the even sample before
  Linear = 1,  // 2 neighbours
  Cubic = 2,   // 4 neighbours, as in the paper that README.md names
};

/// Continuation of a clip after its last frame: FORMAT.md, loop.
enum class LoopKind : std::uint8_t {
  None = 0,
  Repeats = 1,  // the last frame repeats the first pose
  Follows = 2,  // the first frame comes after the last one
};

/// Codings of the motion that readers distinguish.
inline constexpr std::uint8_t kComparison = 0;  // file of a comparison method, without wavelets
inline constexpr std::uint8_t kAdaptive = 3;

/// The solver of an IK correction, which turns the joints of a limb.
enum class Solver : std::uint8_t {
  CyclicDescent = 1,  // as in the paper that README.md names: one joint after the other, repeatedly
  NearestPose = 2,    // moves the limb least: two bones in closed form, other limbs by damped least
                      // squares
};

inline constexpr int kMostEffectors = 32;

}  // namespace mocapress::runtime
