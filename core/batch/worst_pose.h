// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/report/picture.h"

namespace mocapress {

/// The frame with the largest error, with all that is needed to draw it without the clip.
struct WorstPose {
  int frame = 0;
  std::string landmark;  // name of the point with that error
  int point = 0;         // index of that point
  double off_cm = 0;     // the exact error, although stored points are rounded
  double ground_cm = 0;
  Eigen::Vector3d facing = Eigen::Vector3d::UnitZ();
  std::vector<DrawnBone> bones;
  PosePoints original;
  PosePoints decoded;
};

/// The landmarks at one frame, from rows of landmark_tracks().
PosePoints points_at(const TrackRows& tracks, int frame);

/// The height of the ground: the lowest at which any landmark of landmark_tracks() rests.
double ground_of(const Eigen::MatrixXd& original_tracks);

/// Makes the pose from the landmarks of the original and the decoded clip. Rounds points to 0.1 mm,
/// as they are stored.
WorstPose worst_pose(const Skeleton& skeleton, PosePoints original, PosePoints decoded,
                     double ground_cm, const WorstPoint& worst);

/// Draws the pose as SVG: the compressed figure over the original, with the gap marked.
std::string worst_scene(const WorstPose& pose, const std::string& label);

}  // namespace mocapress
