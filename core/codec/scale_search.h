// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/closed_loop.h"
#include "core/codec/encoder.h"
#include "core/codec/goal.h"
#include "core/codec/trial.h"

namespace mocapress {

/// Quantises at a scale with so much work, frames weighted (or none: alike), and codes that.
using AttemptScale = std::function<Trial(double scale, const ClosedLoopWork& work,
                                         const Eigen::VectorXd& frame_weights)>;

/// Where a search begins and ends.
struct ScaleGuess {
  double likely;                   // to meet the target
  std::function<double()> finest;  // asked for after the first trial; finer ones do not fit
};

/// The best trial that a search for the closed loop's scale comes to, with its bytes coded. It
/// meets the goal unless that is out of reach, the effort is a draft, or a trial was incomplete.
Trial search_scale(const ScaleGuess& guess, const Target& target, const Goal& goal, Effort effort,
                   const AttemptScale& attempt);

/// Errors at single frames decide the scale that a hard bound needs. Larger scales may do where
/// those frames weigh more: `raise` makes them, given what a trial decodes to. Replaces `best`
/// where something smaller is found.
void hold_worst_frames(const Goal& goal, int frames, Effort effort, const AttemptScale& attempt,
                       const std::function<void(const Trial&, Eigen::VectorXd& weights)>& raise,
                       Trial& best);

}  // namespace mocapress
