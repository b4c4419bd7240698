// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/encode/closed_loop/closed_loop.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/codec/encode/search/goal.h"

namespace mocapress {

/// Quantises at a scale and codes the result. Empty `frame_weights` weigh all frames alike.
using AttemptScale =
    std::function<Trial(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights)>;

/// Quantises so that the quadratic model gives an eps_x of `eps_cm`. Without `trial` it calls
/// ClosedLoop::quantise_to(), which starts from `scale`; otherwise ClosedLoop::settle(), which
/// keeps the scale of the trial.
using SettleTrial = std::function<Trial(double eps_cm, double scale, const Trial* trial)>;

/// Drops as many coefficients as a hard maximum allows: ClosedLoop::coarsen(), with one bound for
/// each frame.
using CoarsenTrial = std::function<Trial(const Trial& trial, const Eigen::VectorXd& bound_cm)>;

/// The start and the limits of a search.
struct ScaleGuess {
  double likely;                   // the scale that is likely to meet the target
  std::function<double()> finest;  // the finest scale a file can hold; call it after a trial
  bool dear = false;               // trials are slow: take few, stop anywhere within the tolerance
  bool corrected = false;          // with IK correction, which mends less than sweeps expect
};

/// The trials that a search can run.
struct ScaleTrials {
  AttemptScale attempt;
  CoarsenTrial coarsen;
  SettleTrial settle = {};  // empty: trials cannot be settled
};

/// Searches the closed loop's scale and returns the best trial, with its bytes coded. It meets the
/// goal unless that is out of reach, the effort is a draft, or a trial was incomplete. Under a hard
/// maximum the errors at single frames decide the scale. The search then also tries larger scales
/// with more weight on those frames, and coarsens what it finds.
Trial search_scale(const ScaleGuess& guess, const Target& target, const Goal& goal, Effort effort,
                   int frames, const ScaleTrials& trials);

}  // namespace mocapress
