// SPDX-License-Identifier: MIT
// Quantisation and channel trade-offs decided together, by what they do to eps_x.
#pragma once

#include "core/base/progress.h"
#include "core/codec/adaptive.h"
#include "core/codec/target.h"
#include "core/select/error_model.h"
#include "core/select/ranking.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {

struct ClosedLoopProgress {
  int sweep = 0;
  double eps_cm = 0;  // by the quadratic model
};

struct ClosedLoopEffort {
  int compensations = 1;
  int sweeps = 4;
  double dead_zone = 0.32;
  double lambda = 0.04;
};

class ClosedLoop {
 public:
  ClosedLoop(const RankedCoefficients& transform, const Clip& original, const ErrorModel& model);

  struct Result {
    QuantisedSignals coded;
    double eps_cm = 0;  // by the quadratic model
    int sweeps = 0;
    bool complete = true;  // false: the observer ended it
  };

  /// Quantised in steps of about `scale` cm, as they move the landmarks.
  Result quantise(double scale, const ClosedLoopEffort& effort = {},
                  const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Of finer scales the largest coefficients would not fit.
  double finest_scale() const;

  /// A first guess at the scale that meets a target.
  double likely_scale(const Target& target) const;

 private:
  friend class ClosedLoopRun;
  const RankedCoefficients& transform_;
  const Clip& original_;
  const ErrorModel& model_;
  Synthesis synthesis_;
  std::vector<double> gains_;
  Eigen::MatrixXd curvature_;              // frames x channels
  Eigen::MatrixXd coefficient_curvature_;  // H
  Eigen::VectorXd mean_curvature_;
};

}  // namespace mocapress
