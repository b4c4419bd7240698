// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>

#include "core/codec/encode/trial_coder.h"

namespace mocapress {

/// Encodes by the closed loop: searches the scale that meets the target. Each trial is quantised,
/// gets its ends corrected, and is measured.
class LoopEncode {
 public:
  /// Coder and passes must outlive this object. `remembers`: keep results for encodes that differ
  /// only in r_IK.
  LoopEncode(TrialCoder& coder, Passes& passes, bool remembers)
      : coder_(coder), passes_(passes), remembers_(remembers) {}

  Trial run(Effort effort);

  /// Runs one scale, without measuring against the target.
  Trial run_at(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights);

  /// Runs ClosedLoop::coarsen() on a quantised clip, with a bound for each frame.
  Trial coarsen(ClosedLoop::Result quantised, const Eigen::VectorXd& bound_cm);

 private:
  double balance_joints(double scale);
  Trial attempt(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                Effort effort);
  Trial settle(double eps_cm, double scale, const Trial* trial);
  ClosedLoop::Result settle_again(const Trial& trial, double eps_cm);
  ClosedLoop::Result settle_anew(double eps_cm, double scale);
  ClosedLoop::Result quantise(double scale, ClosedLoopWork work,
                              const Eigen::VectorXd& frame_weights);

  TrialCoder& coder_;
  Passes& passes_;
  const bool remembers_;
  TrialBytes bytes_ = TrialBytes::Coded;
  std::map<std::pair<float, ClosedLoopWork>, ClosedLoop::Result> quantised_;
  std::map<std::pair<double, double>, ClosedLoop::Result> settled_;  // by error and scale
};

}  // namespace mocapress
