// SPDX-License-Identifier: MIT
#include "core/metrics/body_figures.h"

#include <numeric>

#include "core/motion/body_part.h"

namespace mocapress {
namespace {

/// Without what carries them and what is in them, where these have other names.
std::vector<int> heads(const Skeleton& skeleton) {
  const std::vector<int> all = joints_of(skeleton, BodyPart::Head);
  std::vector<int> heads;
  for (const int j : all) {
    const std::string& name = skeleton.joint(j).name;
    if (name.find("ead") != std::string::npos || name.find("EAD") != std::string::npos)
      heads.push_back(j);
  }
  return heads.empty() ? all : heads;
}

}  // namespace

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion) {
  const auto degrees = [&](const std::vector<int>& joints) -> std::optional<double> {
    if (joints.empty()) return std::nullopt;
    return distortion.degrees(joints);
  };
  std::vector<int> all(static_cast<std::size_t>(skeleton.joint_count()));
  std::iota(all.begin(), all.end(), 0);
  return {.surface = distortion.surface,
          .shell = distortion.shell,
          .head_degrees = degrees(heads(skeleton)),
          .hand_degrees = degrees(joints_of(skeleton, BodyPart::Hands)),
          .angle_rms_degrees = distortion.degrees(all),
          .ends = distortion.ends};
}

}  // namespace mocapress
