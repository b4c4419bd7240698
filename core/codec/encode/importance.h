// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/feet/contact_spans.h"
#include "core/motion/clip.h"
#include "core/motion/measured_points.h"
#include "core/select/point_term.h"

namespace mocapress {

/// What the encoder is to take more care of than eps_x does. It moves where the error goes; what is
/// reported and promised stays eps_x as its weighting has it.
struct Importance {
  // For each joint, by how much the weights of its landmarks are multiplied; empty: none.
  std::vector<double> joints;
  // How many times its share a foot weighs while it stands; 0: no more than else. Keeps it planted
  // without a correction.
  double contacts = 0;

  bool is_even() const { return joints.empty() && contacts == 0; }
  bool operator==(const Importance&) const = default;
};

/// measured_points(), their weights multiplied by what their joints are worth, with their sum as
/// before. Throws Error unless there is one finite factor, not below 0, for each joint, and some
/// weight is left.
MeasuredPoints important_points(const Skeleton& skeleton, Weighting weighting,
                                const Importance& importance);

/// The points that stand, and how much more they weigh then: one for each joint of the contacts.
std::vector<PointResponse> standing_points(const Skeleton& skeleton,
                                           const Eigen::MatrixXd& original_tracks,
                                           const std::vector<ContactSpan>& contacts,
                                           double importance);

}  // namespace mocapress
