// SPDX-License-Identifier: MIT
#include "tests/support/landmark_jacobian.h"

namespace mocapress::test {

Eigen::MatrixXd landmark_jacobian(const Motion& motion, int frame) {
  return point_jacobian(motion, landmarks(motion.skeleton), frame);
}

Eigen::MatrixXd point_jacobian(const Motion& motion, const std::vector<Landmark>& points,
                               int frame) {
  constexpr double kStep = 1e-5;
  const auto positions = [&](const Clip& clip) {
    return Eigen::VectorXd(point_tracks(motion.skeleton, points, clip).row(0).transpose());
  };
  const Clip one_frame{120, motion.clip.channels.row(frame)};
  Eigen::MatrixXd jacobian(positions(one_frame).size(), motion.skeleton.channel_count());
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    Clip ahead = one_frame;
    Clip behind = one_frame;
    ahead.channels(0, c) += kStep;
    behind.channels(0, c) -= kStep;
    jacobian.col(c) = (positions(ahead) - positions(behind)) / (2 * kStep);
  }
  return jacobian;
}

}  // namespace mocapress::test
