// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace mocapress {

struct Pose;

/// Positions whose differences from the original are `times` as large. Both have the same size.
Eigen::MatrixXd exaggerated(const Eigen::MatrixXd& original, const Eigen::MatrixXd& other,
                            double times);

/// Changes `pose` so that positions and rotations differ from the original's `times` as much.
void exaggerate(const Pose& original, double times, Pose& pose);

/// The same for poses that are computed when asked for. Empty if either is.
std::function<void(int frame, Pose& pose)> exaggeratedPoses(
    const std::function<void(int frame, Pose& pose)>& original,
    const std::function<void(int frame, Pose& pose)>& other, double times);

}  // namespace mocapress
