// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/figure_front.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/motion/body.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

constexpr Eigen::Index kLooks = 256;     // at most so many frames are examined
constexpr double kSteadyEnough = 0.5;    // least length of the mean of the facing unit vectors
constexpr double kLeastCrossing = 1e-3;  // cm between hips, seen from above

/// Joints of a region whose parents are not in that region.
std::vector<int> topsOf(const Skeleton& skeleton, const std::vector<BodyRegion>& regions,
                        BodyRegion region) {
  const auto is_in = [&](int joint) {
    return joint >= 0 && regions[static_cast<std::size_t>(joint)] == region;
  };
  std::vector<int> tops;
  for (int joint = 0; joint < skeleton.joint_count(); ++joint)
    if (is_in(joint) && !is_in(skeleton.joint(joint).parent)) tops.push_back(joint);
  return tops;
}

struct Toe {
  int ankle, landmark;
};

/// Landmarks at and below the ankles, each with its ankle.
std::vector<Toe> toesOf(const Skeleton& skeleton, const std::vector<int>& ankles) {
  std::vector<Toe> toes;
  const std::vector<Landmark> points = landmarks(skeleton);
  for (std::size_t point = 0; point < points.size(); ++point)
    for (int joint = points[point].joint; joint >= 0; joint = skeleton.joint(joint).parent)
      if (std::find(ankles.begin(), ankles.end(), joint) != ankles.end())
        toes.push_back({joint, static_cast<int>(point)});
  return toes;
}

}  // namespace

std::optional<float> frontOf(const Skeleton& skeleton, const Eigen::MatrixXd& tracks) {
  const std::vector<BodyRegion> regions = body_regions(skeleton);
  if (regions.empty() || tracks.rows() == 0) return {};
  const std::vector<int> hips = topsOf(skeleton, regions, BodyRegion::Thigh);
  const std::vector<int> ankles = topsOf(skeleton, regions, BodyRegion::Foot);
  if (hips.size() != 2 || ankles.size() != 2) return {};
  const std::vector<Toe> toes = toesOf(skeleton, ankles);
  // A landmark's floor coordinates: z and x.
  const auto at = [&](Eigen::Index frame, int landmark) {
    return Eigen::Vector2d(tracks(frame, 3 * landmark + 2), tracks(frame, 3 * landmark));
  };
  Eigen::Vector2d first = Eigen::Vector2d::Zero(), sum = Eigen::Vector2d::Zero();
  double ahead = 0;  // cm, summed: how far the toes are ahead of the ankles; negative: behind
  int looks = 0;
  for (Eigen::Index f = 0; f < tracks.rows(); f += 1 + tracks.rows() / kLooks) {
    const Eigen::Vector2d across = at(f, hips[1]) - at(f, hips[0]);
    if (across.norm() < kLeastCrossing) continue;
    const Eigen::Vector2d facing = Eigen::Vector2d(-across.y(), across.x()) / across.norm();
    for (const Toe& toe : toes) ahead += facing.dot(at(f, toe.landmark) - at(f, toe.ankle));
    if (looks++ == 0) first = facing;
    sum += facing;
  }
  if (looks == 0 || ahead == 0) return {};
  const Eigen::Vector2d front =
      (sum.norm() > kSteadyEnough * looks ? sum : first) * (ahead > 0 ? 1 : -1);
  return static_cast<float>(std::atan2(front.y(), front.x()));
}

}  // namespace mocapress
