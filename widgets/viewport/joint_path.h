// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "widgets/viewport/figure_shape.h"

namespace mocapress {

/// The way of a landmark around a frame, `reach` frames to either side, thinner the further away in
/// time. `radius` in cm.
std::vector<Capsule> jointPath(const Eigen::MatrixXd& tracks, int landmark, int frame, int reach,
                               float radius);

}  // namespace mocapress
