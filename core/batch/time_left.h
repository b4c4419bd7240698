// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/batch/run.h"

namespace mocapress {

/// How long a running batch still takes, by how fast it was so far. Until the next clip ends it
/// never grows: how far a clip is, is a guess, and a long one says nothing about the others.
class TimeLeft {
 public:
  /// With every news of the batch; `elapsed_seconds` without pauses.
  void update(const BatchCounts& counts, double elapsed_seconds);

  /// Unset until a clip was worked on to its end.
  const std::optional<double>& seconds() const { return seconds_; }

 private:
  std::size_t done_ = 0;
  std::optional<double> seconds_;
};

}  // namespace mocapress
