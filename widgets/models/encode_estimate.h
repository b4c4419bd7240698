// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/codec/encode/encoder.h"

namespace mocapress {

/// Estimates the share done and the remaining time of a running encode. The number of passes is not
/// known beforehand: beyond the usual number, the share grows ever more slowly. It never falls.
class EncodeEstimate {
 public:
  explicit EncodeEstimate(const EncodeSettings& options);

  /// Adds a progress state, `seconds` after the start of the encode.
  void add(const EncodeProgress& state, double seconds);

  double share() const { return share_; }  // share done, 0 to 1

  /// Unset while there is too little data for an estimate.
  std::optional<double> secondsLeft() const;

 private:
  double usual_passes_;
  double pass_length_;  // expected iterations in a pass
  int pass_ = 0;
  int iterations_ = 0;  // iterations done in this pass
  double share_ = 0;
  double seconds_ = 0;
};

/// Share of an annealing pass that is done, 0 to 1, on a logarithmic scale: the step halves from
/// first_step down to 0.
double passProgress(const EncodeProgress& state);

}  // namespace mocapress
