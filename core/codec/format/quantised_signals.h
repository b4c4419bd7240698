// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/runtime/format/coded_motion.h"
#include "core/select/ranking.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

/// Wavelet coefficients of signals in whole steps. In every band a signal's step is divided by
/// Lifting::gains(), so that a step matters equally in all bands.
struct QuantisedSignals {
  float scale = 1;                 // rounded by file_scale()
  std::vector<int> step_exponent;  // for each signal: its step is scale * 2^(-step_exponent / 2)
  Eigen::MatrixXi values;          // coefficients x signals, coarse to fine

  double step(int signal) const;
  int signal_count() const { return static_cast<int>(values.cols()); }

  bool operator==(const QuantisedSignals& other) const {
    return scale == other.scale && step_exponent == other.step_exponent &&
           values.rows() == other.values.rows() && values.cols() == other.values.cols() &&
           values == other.values;
  }
};

using runtime::kLeastStepExponent;
using runtime::kMostStepExponent;
using runtime::kMostSteps;
using runtime::step_of;

/// The nearest scale that a file can store: 8 binary digits.
float file_scale(double scale);

/// The step_exponent of the largest step that is at most `step`.
int step_exponent_for(double step, float scale);

/// Rounds chosen coefficients to steps about as large as the largest coefficient that their signal
/// drops. `scales` make signals comparable, as for StandardOrder.
QuantisedSignals quantise_kept(const RankedCoefficients& ranked, const std::vector<double>& scales,
                               const Kept& kept, float scale);

/// Appends signals of the same scale and length.
void append(const QuantisedSignals& more, QuantisedSignals& to);

/// Computes the signals: samples x signals.
Eigen::MatrixXd reconstruct(const QuantisedSignals& coded, const Lifting& lifting);

}  // namespace mocapress
