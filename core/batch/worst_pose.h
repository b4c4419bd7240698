// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/report/picture.h"

namespace mocapress {

/// The frame with the largest error, in enough detail to draw it without the clip.
struct WorstPose {
  int frame = 0;
  std::string landmark;  // the point's name
  int point = 0;         // its index
  double off_cm = 0;     // exact distance, although points are rounded
  double ground_cm = 0;
  Eigen::Vector3d facing = Eigen::Vector3d::UnitZ();
  std::vector<DrawnBone> bones;
  PosePoints original;
  PosePoints decoded;
};

/// The landmarks at a frame of landmark_tracks().
PosePoints points_at(const TrackRows& tracks, int frame);

/// The ground: the lowest height at which any landmark of landmark_tracks() rests.
double ground_of(const Eigen::MatrixXd& original_tracks);

/// Builds the pose from the landmarks of original and decoded clip. Points are rounded to 0.1 mm,
/// as they are stored.
WorstPose worst_pose(const Skeleton& skeleton, PosePoints original, PosePoints decoded,
                     double ground_cm, const WorstPoint& worst);

/// The pose as SVG: the compressed figure over its original, with the gap marked.
std::string worst_scene(const WorstPose& pose, const std::string& label);

}  // namespace mocapress
