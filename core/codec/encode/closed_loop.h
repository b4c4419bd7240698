// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/codec/encode/error_bound.h"
#include "core/codec/encode/target.h"
#include "core/codec/format/quantised_signals.h"
#include "core/select/error_model.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {

/// How hard it tries.
struct ClosedLoopWork {
  bool compensate = true;  // each channel for the others, once
  int sweeps = 8;          // over all coefficients
  bool pairs = false;      // the later ones with two channels at a time, too
};

struct ClosedLoopProgress {
  int sweep = 0;
  double eps_cm = 0;  // by the quadratic model, frames weighted as asked
};

/// Quantisation and the trade between channels decided together, by what they do to eps_x.
///
/// Each channel's step is in inverse proportion to how far it moves the landmarks. From there on
/// every change of a coefficient is judged by what it costs in eps_x^2, given the errors of all
/// others, against what it saves in bits; so a knee makes good what the hip lost. Const and safe to
/// use from several threads at a time; the outcome is always the same.
class ClosedLoop {
 public:
  /// All must outlive this.
  ClosedLoop(const Coefficients& transform, const Clip& original, const ErrorModel& model);

  struct Result {
    QuantisedSignals coded;
    double eps_cm = 0;  // by the quadratic model, frames weighted as asked
    int sweeps = 0;
    bool complete = true;  // false: the observer ended it
  };

  /// Quantised in steps of about `scale` cm, as they move the landmarks. Errors of a frame count by
  /// its weight, one for each, or all alike where there are none.
  Result quantise(double scale, const ClosedLoopWork& work = {},
                  const Eigen::VectorXd& frame_weights = {},
                  const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Drops more and more of what was quantised, what is cheapest first, as long as the bound holds.
  /// Frames count alike. Ends near the bound, where a sweep saves little more.
  Result coarsen(QuantisedSignals coded, ErrorBound& bound,
                 const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Of finer scales the largest coefficients would not fit.
  double finest_scale() const;

 private:
  friend class ClosedLoopRun;

  /// |synthesis function|^2 weighted by a curvature, coefficients x channels.
  Eigen::MatrixXd coefficient_curvature(const Eigen::MatrixXd& curvature) const;

  const Coefficients& transform_;
  const Clip& original_;
  const ErrorModel& model_;
  Synthesis synthesis_;
  Eigen::VectorXd gains_;
  Eigen::MatrixXd curvature_;              // of the model, nowhere zero
  Eigen::MatrixXd coefficient_curvature_;  // all frames alike
  Eigen::VectorXd mean_curvature_;
};

/// A first guess at the scale that meets a target for a clip of so many bytes.
double likely_scale(const Target& target, std::size_t raw_bytes);

}  // namespace mocapress
