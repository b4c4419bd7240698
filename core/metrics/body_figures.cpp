// SPDX-License-Identifier: MIT
#include "core/metrics/body_figures.h"

#include <numeric>

#include "core/motion/body_part.h"

namespace mocapress {

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion) {
  const auto degrees = [&](const std::vector<int>& joints) -> std::optional<double> {
    if (joints.empty()) return std::nullopt;
    return distortion.degrees(joints);
  };
  std::vector<int> all(static_cast<std::size_t>(skeleton.joint_count()));
  std::iota(all.begin(), all.end(), 0);
  return {.surface = distortion.surface,
          .shell = distortion.shell,
          .head_degrees = degrees(head_joints(skeleton)),
          .hand_degrees = degrees(joints_of(skeleton, BodyPart::Hands)),
          .angle_rms_degrees = distortion.degrees(all),
          .ends = distortion.ends};
}

}  // namespace mocapress
