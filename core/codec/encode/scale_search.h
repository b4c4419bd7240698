// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/encode/closed_loop.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/encode/goal.h"

namespace mocapress {

/// Quantises at a scale and codes the result. `frame_weights` is empty where frames count alike.
using AttemptScale = std::function<Trial(double scale, const ClosedLoopWork& work,
                                         const Eigen::VectorXd& frame_weights)>;

/// Drops what a hard maximum allows to be dropped: ClosedLoop::coarsen().
using CoarsenTrial = std::function<Trial(const Trial& trial, double bound_cm)>;

/// Where a search begins and ends.
struct ScaleGuess {
  double likely;                   // the scale that is likely to meet the target
  std::function<double()> finest;  // asked for after the first trial; finer ones do not fit
  bool dear = false;               // trials are slow: take few, end anywhere within the tolerance
  bool corrected = false;          // by IK, which mends less than the sweeps expect
};

/// What a search tries.
struct ScaleTrials {
  AttemptScale attempt;
  CoarsenTrial coarsen;
};

/// Searches the closed loop's scale and returns the best trial, with its bytes coded. It meets the
/// goal unless that is out of reach, the effort is a draft, or a trial was incomplete. Under a hard
/// maximum the errors at single frames decide the scale. The search then also tries larger scales
/// with more weight on those frames, and coarsens what it finds.
Trial search_scale(const ScaleGuess& guess, const Target& target, const Goal& goal, Effort effort,
                   int frames, const ScaleTrials& trials);

}  // namespace mocapress
