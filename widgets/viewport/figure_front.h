// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/motion/skeleton.h"

namespace mocapress {

/// The direction that a figure faces, in radians from +z towards +x: horizontal, at right angles to
/// the line between the hips, on the side where the toes point. It is the mean over the clip, or
/// the direction in the first frame if the figure turns so much that the mean says nothing. Unset
/// without two legs that end in feet. `tracks` are landmark_tracks().
std::optional<float> frontOf(const Skeleton& skeleton, const Eigen::MatrixXd& tracks);

}  // namespace mocapress
