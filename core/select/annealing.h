// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 5, Algorithm 1.
// Deviation: candidates are compared by the quadratic error model, not by forward kinematics.
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/select/error_model.h"
#include "core/select/ranking.h"

namespace mocapress {

struct AnnealingProgress {
  int iteration = 0;
  int step = 0;        // s: coefficients moved at a time
  int first_step = 0;  // s at the beginning
  double eps_cm = 0;   // estimated by the quadratic model
};

struct AnnealingReport {
  Kept kept;  // the vector m; its sum is that of the start
  int iterations = 0;
  double first_eps_cm = 0;  // estimated by the quadratic model
  double eps_cm = 0;        // never above first_eps_cm
  bool complete = true;     // false: the observer stopped it
};

/// Moves coefficients between channels while eps_x falls. The same seed gives the same result. Runs
/// on one thread: its steps are so short that waiting for other threads on a busy machine would
/// cost more than all steps together.
AnnealingReport anneal(const RankedCoefficients& ranked, const ErrorModel& model, const Kept& start,
                       std::uint64_t seed = 1, const Observer<AnnealingProgress>& observer = {});

}  // namespace mocapress
