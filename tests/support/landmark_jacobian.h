// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/landmarks.h"

namespace mocapress::test {

/// The movement of each landmark by each channel (3 * landmarks x channels, cm per unit), by finite
/// differences of forward kinematics. It is slow and shares no code with the error model.
Eigen::MatrixXd landmark_jacobian(const Motion& motion, int frame);

/// The same for any points.
Eigen::MatrixXd point_jacobian(const Motion& motion, const std::vector<Landmark>& points,
                               int frame);

}  // namespace mocapress::test
