// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/encode/closed_loop.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/encode/goal.h"

namespace mocapress {

/// Quantises at a scale with so much work, frames weighted (or none: alike), and codes that.
using AttemptScale = std::function<Trial(double scale, const ClosedLoopWork& work,
                                         const Eigen::VectorXd& frame_weights)>;

/// Drops what a hard maximum leaves room for: ClosedLoop::coarsen().
using CoarsenTrial = std::function<Trial(const Trial& trial, double bound_cm)>;

/// Where a search begins and ends.
struct ScaleGuess {
  double likely;                   // to meet the target
  std::function<double()> finest;  // asked for after the first trial; finer ones do not fit
  bool dear = false;               // trials are slow: take few, end anywhere within the tolerance
  bool corrected = false;          // by IK, which mends less than the sweeps count on
};

/// What a search tries.
struct ScaleTrials {
  AttemptScale attempt;
  CoarsenTrial coarsen;
};

/// The best trial that a search for the closed loop's scale comes to, with its bytes coded. It
/// meets the goal unless that is out of reach, the effort is a draft, or a trial was incomplete.
/// Errors at single of the `frames` decide the scale that a hard maximum needs: there, larger
/// scales are tried with more weight on those, and what is found is coarsened.
Trial search_scale(const ScaleGuess& guess, const Target& target, const Goal& goal, Effort effort,
                   int frames, const ScaleTrials& trials);

}  // namespace mocapress
