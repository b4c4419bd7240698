// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/metrics/distortion.h"

namespace mocapress {

/// What a distortion is on the body, in a few figures.
struct BodyFigures {
  Spread surface;  // cm
  Spread shell;
  std::optional<double> head_degrees;  // how far they are turned in the world, RMS; unset: none is
  std::optional<double> hand_degrees;  // known by its name
  double angle_rms_degrees = 0;        // over all joints
  EndErrors ends;

  bool operator==(const BodyFigures&) const = default;
};

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion);

}  // namespace mocapress
