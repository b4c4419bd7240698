// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// The largest distance (cm), at any frame, of a joint of `original` from its namesake in `reread`.
inline double largest_joint_move(const Motion& original, const Motion& reread) {
  EXPECT_EQ(reread.clip.frames(), original.clip.frames());
  EXPECT_NEAR(reread.clip.sample_rate_hz, original.clip.sample_rate_hz, 1e-6);
  if (reread.clip.frames() != original.clip.frames()) return INFINITY;
  const Eigen::MatrixXd wanted = landmark_tracks(original.skeleton, original.clip);
  const Eigen::MatrixXd found = landmark_tracks(reread.skeleton, reread.clip);
  double largest = 0;
  for (int j = 0; j < original.skeleton.joint_count(); ++j) {
    const int same = reread.skeleton.find(original.skeleton.joint(j).name);
    EXPECT_GE(same, 0) << original.skeleton.joint(j).name;
    if (same >= 0)
      largest = std::max(largest, (found.middleCols<3>(3 * same) - wanted.middleCols<3>(3 * j))
                                      .rowwise()
                                      .norm()
                                      .maxCoeff());
  }
  return largest;
}

}  // namespace mocapress::test
