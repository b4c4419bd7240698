// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/feet/contact_spans.h"
#include "core/feet/footskate.h"
#include "core/metrics/distortion.h"
#include "core/metrics/visibility.h"
#include "core/motion/clip.h"

namespace mocapress {

/// A decoded motion measured against its original.
struct Comparison {
  Distortion distortion;
  Footskate footskate;  // beyond the original's own sliding
  Visibility visibility;
};

/// Throws Error if `decoded` differs from the original in its number of channels or frames.
void require_same_shape(const Clip& original, const Clip& decoded);

/// `original_body` is body_tracks() of the original, `contacts` are those of its feet. Throws like
/// require_same_shape().
Comparison compare(const Motion& original, const Eigen::MatrixXd& original_body,
                   const Clip& decoded, const std::vector<ContactSpan>& contacts,
                   const SightLimits& limits = {});

}  // namespace mocapress
