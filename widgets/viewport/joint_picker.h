// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "widgets/viewport/orbit_camera.h"

namespace mocapress {

struct PickedJoint {
  int joint;
  double distance;  // logical pixels from the cursor
};

/// The joint seen nearest to the cursor, within `reach` pixels; of joints at one place the first,
/// which is nearest to the root. The first `joint_count` landmarks of `tracks` are the joints.
std::optional<PickedJoint> pickJoint(const OrbitCamera& camera, const Eigen::MatrixXd& tracks,
                                     int frame, int joint_count, const QPointF& cursor,
                                     double reach = 12);

}  // namespace mocapress
