// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace mocapress {

/// Effort of the closed loop to find a smaller file. Other methods have one effort only.
enum class Effort {
  Draft,    // while a slider moves: near the target, which is not promised
  Default,  // meets the target
  Best,     // about 1 % smaller, in about three times the time
};

/// "draft", "default", "best".
std::string_view name(Effort effort);

/// The state of a running encode. A target other than the coefficient ratio takes several passes.
struct EncodeProgress {
  int pass = 0;       // from 0
  int iteration = 0;  // in this pass: of annealing, or sweeps of a closed loop
  int step = 0;  // coefficients moved at a time, halved until it is 0; always 0 in a closed loop
  int first_step = 0;  // the step the pass began with
  double eps_cm = 0;   // by the quadratic model, in the chosen weighting
};

}  // namespace mocapress
