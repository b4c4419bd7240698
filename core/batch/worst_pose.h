// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/study/picture.h"

namespace mocapress {

/// The frame at which a point is furthest off: enough to draw it without the clip.
struct WorstPose {
  int frame = 0;
  std::string landmark;  // the point's name
  int point = 0;         // its index
  double ground_cm = 0;
  Eigen::Vector3d facing = Eigen::Vector3d::UnitZ();
  std::vector<DrawnBone> bones;
  PosePoints original;
  PosePoints decoded;
};

/// Tracks as landmark_tracks() gives them. Rounded to 0.1 mm, as it is kept.
WorstPose worst_pose(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                     const Eigen::MatrixXd& decoded_tracks, const WorstPoint& worst);

/// A scene as SVG: the compressed figure over its original, the gap marked.
std::string worst_scene(const WorstPose& pose, const std::string& label);

}  // namespace mocapress
