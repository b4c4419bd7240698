// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// How much errors of each frame are to count so that the ends of a clip come out no worse than the
/// rest: there fewer coefficients share in an error, and games blend and loop there.
Eigen::VectorXd end_weights(int frames, double sample_rate_hz);

}  // namespace mocapress
