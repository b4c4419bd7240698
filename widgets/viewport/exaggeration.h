// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace mocapress {

struct Pose;

/// Returns positions that differ from `original` `times` as much as `other` does. Both have the
/// same size.
Eigen::MatrixXd exaggerated(const Eigen::MatrixXd& original, const Eigen::MatrixXd& other,
                            double times);

/// Changes `pose` so that its positions and rotations differ from the original's `times` as much.
void exaggerate(const Pose& original, double times, Pose& pose);

/// Exaggerates poses that are computed on request. Empty if either function is.
std::function<void(int frame, Pose& pose)> exaggeratedPoses(
    const std::function<void(int frame, Pose& pose)>& original,
    const std::function<void(int frame, Pose& pose)>& other, double times);

}  // namespace mocapress
