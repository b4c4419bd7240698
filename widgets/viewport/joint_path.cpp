// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/joint_path.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

constexpr int kMostPieces = 30;  // to either side: long reaches are drawn in longer pieces
constexpr float kThinnestTrail = 0.35f;

}  // namespace

std::vector<Capsule> jointPath(const Eigen::MatrixXd& tracks, int landmark, int frame, int reach,
                               float radius) {
  const int last = static_cast<int>(tracks.rows()) - 1;
  const int step = std::max(1, reach / kMostPieces);
  const auto radiusAt = [&](int t) {
    const float away = static_cast<float>(std::abs(t - frame)) / static_cast<float>(reach);
    return radius * (1 - (1 - kThinnestTrail) * away);
  };
  std::vector<Capsule> path;
  const auto add = [&](int a, int b) {
    path.push_back({landmarkAt(tracks, a, landmark), radiusAt(a), landmarkAt(tracks, b, landmark),
                    radiusAt(b), 0, 0});
  };
  const int first = std::max(0, frame - reach);
  const int end = std::min(last, frame + reach);
  for (int t = frame; t > first; t -= step) add(t, std::max(t - step, first));
  for (int t = frame; t < end; t += step) add(t, std::min(t + step, end));
  return path;
}

}  // namespace mocapress
