// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/codec/encode/encoder.h"

namespace mocapress {

/// How far a running encode is, and how long it will still take. How many passes a target takes is
/// not known beforehand: beyond what is usual the share grows ever slower, and never runs back.
class EncodeEstimate {
 public:
  explicit EncodeEstimate(const EncodeSettings& options);

  /// A state, so many seconds after the encode began.
  void add(const EncodeProgress& state, double seconds);

  double share() const { return share_; }  // done, 0 to 1

  /// Unset until there is enough to go by.
  std::optional<double> secondsLeft() const;

 private:
  double usual_passes_;
  double pass_length_;  // iterations of a pass
  int pass_ = 0;
  int iterations_ = 0;  // of the pass so far
  double share_ = 0;
  double seconds_ = 0;
};

/// Share done of an annealing, 0 to 1: the step halves from first_step until it is 0.
double passProgress(const EncodeProgress& state);

}  // namespace mocapress
