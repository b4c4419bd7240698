// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/contact/contact_spans.h"

namespace mocapress {

/// A contact during which the decoded foot slid further than the original.
struct SlideFinding {
  ContactSpan span;
  double slid_cm = 0;           // horizontal travel, decoded minus original
  double worst_speed_cm_s = 0;  // horizontal, of the decoded point
  int worst_frame = 0;
};

/// Footskate of a decoded clip: what it adds to the original's own sliding.
struct Footskate {
  double total_cm = 0;  // over all contacts; a contact that slid less than the original counts 0
  std::vector<SlideFinding> findings;  // one a contact that slid further, the worst first
};

/// Horizontal (x, z) way of each contact's landmark in the decoded clip and in the original, frame
/// to frame. Tracks as landmark_tracks() gives them, equal in shape.
Footskate measure_footskate(const std::vector<ContactSpan>& contacts,
                            const Eigen::MatrixXd& original_tracks,
                            const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz);

}  // namespace mocapress
