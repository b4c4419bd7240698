// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/report/picture.h"

namespace mocapress {

/// The frame at which a point is furthest off: enough to draw it without the clip.
struct WorstPose {
  int frame = 0;
  std::string landmark;  // the point's name
  int point = 0;         // its index
  double off_cm = 0;     // how far off it is: exactly, where points are rounded
  double ground_cm = 0;
  Eigen::Vector3d facing = Eigen::Vector3d::UnitZ();
  std::vector<DrawnBone> bones;
  PosePoints original;
  PosePoints decoded;
};

/// The landmarks at a frame of landmark_tracks().
PosePoints points_at(const TrackRows& tracks, int frame);

/// The lowest that any landmark rests at, of landmark_tracks().
double ground_of(const Eigen::MatrixXd& original_tracks);

/// Of the landmarks where the original and the decoded clip have them. Rounded to 0.1 mm, as it is
/// kept.
WorstPose worst_pose(const Skeleton& skeleton, PosePoints original, PosePoints decoded,
                     double ground_cm, const WorstPoint& worst);

/// A scene as SVG: the compressed figure over its original, the gap marked.
std::string worst_scene(const WorstPose& pose, const std::string& label);

}  // namespace mocapress
