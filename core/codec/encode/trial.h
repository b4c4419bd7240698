// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/compressed_clip.h"

namespace mocapress {

/// Some number of coefficients, chosen and coded, and how far that is from a goal.
struct Trial {
  CompressedClip compressed;
  int count = 0;
  double scale = 0;   // of a closed loop
  double eps_cm = 0;  // of a closed loop, by the quadratic model
  int iterations = 0;
  bool complete = true;
  double achieved = 0;  // the quantity of the target
  double excess = 0;    // core/codec/encode/goal.h
};

}  // namespace mocapress
