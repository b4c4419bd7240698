// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", Figures 1, 3 and 4.

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/skeleton.h"
#include "core/report/sight_chart.h"

namespace mocapress {

/// A tapered limb between two landmarks.
struct DrawnBone {
  int from;  // index of a landmark
  int to;
  double from_radius;  // cm
  double to_radius;
};

/// Makes a body for a skeleton: a head, and limbs that taper like branches. The thickness of
/// a limb grows with the total length of all limbs that it carries (Leonardo's rule).
std::vector<DrawnBone> figure_shape(const Skeleton& skeleton);

/// The horizontal unit vector of the direction in which a figure faces, judged by the joints where
/// its legs meet the trunk. For a figure without legs: the world's z. `points` are the landmarks of
/// one frame, with y up.
Eigen::Vector3d facing(const Skeleton& skeleton, const std::vector<Eigen::Vector3d>& points);

/// World positions (cm) of all landmarks at one frame.
using PosePoints = std::vector<Eigen::Vector3d>;

/// One compression of the pictured clip.
struct PicturedMethod {
  std::string method;
  double ratio = 0;
  double eps_cm = 0;
  double max_error_cm = 0;  // in the weighting of eps_cm
  SightChart sights;
  std::string review;  // script that review_clip() made for review_name(); empty without the viewer
};

/// A frame of the original and of each method.
struct PicturedFrame {
  int frame = 0;
  PosePoints original;
  std::vector<PosePoints> decoded;  // one for each method
};

/// The foot contact that slides most by the first method.
struct PicturedFoot {
  int landmark = 0;
  PicturedFrame pose;  // at the middle of the contact
  std::vector<Eigen::Vector3d> original_trail;
  std::vector<std::vector<Eigen::Vector3d>> trails;  // one for each method
  std::vector<double> slid_cm;                       // for each method: slide beyond the original's
};

/// Selected poses of a clip that several methods compressed to the same ratio.
struct Picture {
  std::string clip;  // path
  double ratio = 0;  // same for every method
  double sample_rate_hz = 120;
  int frames = 0;
  std::vector<DrawnBone> bones;
  std::vector<std::string> landmark_names;
  double ground_cm = 0;    // height of the floor in world space
  Eigen::Vector3d facing;  // the figure's direction in the worst frame
  std::vector<PicturedMethod> methods;
  PicturedFrame worst;                  // frame with the largest error of the first method
  std::vector<PicturedFrame> sequence;  // frames at even distances
  std::optional<PicturedFoot> foot;     // unset: no foot slides
};

/// The name by which a page shows a pictured clip, compressed by one method. It contains the clip's
/// whole path, since clips in different folders may have the same name.
std::string review_name(const Picture& picture, const std::string& method);

}  // namespace mocapress
