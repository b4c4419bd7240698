// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

/// No two key frames are further apart.
inline constexpr int kMostKeyGap = 255;

/// Frames, first and last among them, through which a natural cubic spline keeps within
/// `tolerance` of the curve: added where it is worst until it does.
std::vector<int> choose_key_frames(const Eigen::Ref<const Eigen::VectorXd>& curve,
                                   double tolerance);

}  // namespace mocapress
