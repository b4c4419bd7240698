// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// How each landmark moves with each channel (3 * landmarks x channels, cm per unit), by finite
/// differences of forward kinematics: slow, and sharing nothing with the error model.
Eigen::MatrixXd landmark_jacobian(const Motion& motion, int frame);

}  // namespace mocapress::test
