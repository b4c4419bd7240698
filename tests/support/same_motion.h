// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress::test {

/// The largest distance (cm) of a landmark of `original` from the one with its name in `reread`,
/// over all frames. `names` are the names of `original`'s joints in `reread`.
inline double largest_move(const Motion& original, const Motion& reread,
                           const std::vector<std::string>& names) {
  const std::vector<Landmark> places = landmarks(original.skeleton);
  const std::vector<Landmark> reread_places = landmarks(reread.skeleton);
  const Eigen::MatrixXd tracks = landmark_tracks(original.skeleton, original.clip);
  const Eigen::MatrixXd reread_tracks = landmark_tracks(reread.skeleton, reread.clip);
  EXPECT_EQ(tracks.rows(), reread_tracks.rows());
  double largest = 0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto joint = static_cast<std::size_t>(places[p].joint);
    const std::string name = names[joint] + (p < names.size() ? "" : " end");
    const auto found = std::find_if(reread_places.begin(), reread_places.end(),
                                    [&](const Landmark& place) { return place.name == name; });
    if (found == reread_places.end()) {
      ADD_FAILURE() << "no landmark " << name;
      continue;
    }
    const auto q = found - reread_places.begin();
    const auto difference =
        tracks.middleCols<3>(3 * static_cast<Eigen::Index>(p)) - reread_tracks.middleCols<3>(3 * q);
    largest = std::max(largest, difference.rowwise().norm().maxCoeff());
  }
  return largest;
}

}  // namespace mocapress::test
