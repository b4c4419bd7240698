// SPDX-License-Identifier: MIT
#include "core/metrics/glitches.h"

#include <algorithm>
#include <cassert>

namespace mocapress {
namespace {

/// Distance (cm) of a landmark's error at a frame from the mean of its errors one frame before and
/// after.
double jump(const Eigen::MatrixXd& original, const Eigen::MatrixXd& decoded, Eigen::Index frame,
            Eigen::Index landmark) {
  const auto error = [&](Eigen::Index t) -> Eigen::RowVector3d {
    return decoded.block<1, 3>(t, 3 * landmark) - original.block<1, 3>(t, 3 * landmark);
  };
  return (error(frame) - (error(frame - 1) + error(frame + 1)) / 2).norm();
}

}  // namespace

std::vector<Glitch> find_glitches(const Eigen::MatrixXd& original_tracks,
                                  const Eigen::MatrixXd& decoded_tracks, double least_cm) {
  assert(original_tracks.rows() == decoded_tracks.rows());
  assert(original_tracks.cols() == decoded_tracks.cols());
  const Eigen::Index frames = original_tracks.rows();
  std::vector<Glitch> jumps;  // largest jump of each frame but the first and the last
  for (Eigen::Index t = 1; t + 1 < frames; ++t) {
    Glitch furthest{.frame = static_cast<int>(t)};
    for (Eigen::Index p = 0; p < original_tracks.cols() / 3; ++p)
      if (const double cm = jump(original_tracks, decoded_tracks, t, p); cm > furthest.cm)
        furthest = {static_cast<int>(t), static_cast<int>(p), cm};
    jumps.push_back(furthest);
  }
  // A jump also makes its neighbours jump half as far, so only local maxima count.
  std::vector<Glitch> glitches;
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    const bool stands_out = (i == 0 || jumps[i - 1].cm < jumps[i].cm) &&
                            (i + 1 == jumps.size() || jumps[i + 1].cm <= jumps[i].cm);
    if (stands_out && jumps[i].cm >= least_cm) glitches.push_back(jumps[i]);
  }
  return glitches;
}

}  // namespace mocapress
