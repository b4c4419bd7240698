// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/joint_picker.h"

#include <QLineF>

#include "widgets/viewport/figure_shape.h"

namespace mocapress {

std::optional<PickedJoint> pickJoint(const OrbitCamera& camera, const Eigen::MatrixXd& tracks,
                                     int frame, int joint_count, const QPointF& cursor,
                                     double reach) {
  std::optional<PickedJoint> nearest;
  for (int j = 0; j < joint_count; ++j) {
    const std::optional<QPointF> seen = camera.project(landmarkAt(tracks, frame, j));
    if (!seen) continue;
    const double distance = QLineF(*seen, cursor).length();
    if (distance <= reach && (!nearest || distance < nearest->distance))
      nearest = PickedJoint{j, distance};
  }
  return nearest;
}

}  // namespace mocapress
