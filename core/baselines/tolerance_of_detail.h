// SPDX-License-Identifier: MIT
#pragma once
// Methods that split until a curve fits: their detail, a whole number, says how closely.

namespace mocapress {

inline constexpr int kMostDetail = 8000;

/// In cm; 40 at detail 0.
inline double tolerance_of_detail(int detail) {
  return 40.0 / (1 + detail);
}

}  // namespace mocapress
