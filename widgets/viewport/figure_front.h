// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/motion/skeleton.h"

namespace mocapress {

/// The direction that a figure faces, in radians from +z towards +x: across the line between its
/// hips, where its toes point. It is the mean over the clip, or that of the first frame if the
/// figure turns about too much to have one. Unset without two legs that end in feet.
/// `tracks` are landmark_tracks().
std::optional<float> frontOf(const Skeleton& skeleton, const Eigen::MatrixXd& tracks);

}  // namespace mocapress
