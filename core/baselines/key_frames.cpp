// SPDX-License-Identifier: MIT
// Based on: G. Liu and L. McMillan, "Segment-Based Human Motion Compression", 2006, section on
// temporal coherence.
#include "core/baselines/key_frames.h"

#include "core/baselines/cubic_spline.h"

namespace mocapress {
namespace {

std::vector<int> evenly_spaced(int frames) {
  std::vector<int> keys;
  for (int t = 0; t + 1 < frames; t += kMostKeyGap) keys.push_back(t);
  if (frames > 0) keys.push_back(frames - 1);
  return keys;
}

}  // namespace

std::vector<int> choose_key_frames(const Eigen::Ref<const Eigen::VectorXd>& curve,
                                   double tolerance) {
  std::vector<int> keys = evenly_spaced(static_cast<int>(curve.size()));
  for (bool grown = true; grown;) {
    const Eigen::VectorXd error = (natural_spline(keys, curve(keys)) - curve).cwiseAbs();
    std::vector<int> more{keys.front()};
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
      Eigen::Index worst = 0;
      if (error.segment(keys[i], keys[i + 1] - keys[i]).maxCoeff(&worst) > tolerance && worst > 0)
        more.push_back(keys[i] + static_cast<int>(worst));
      more.push_back(keys[i + 1]);
    }
    grown = more.size() > keys.size();
    keys = std::move(more);
  }
  return keys;
}

}  // namespace mocapress
