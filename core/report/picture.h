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
  int from;  // landmark indices
  int to;
  double from_radius;  // cm
  double to_radius;
};

/// A body for a skeleton: limbs that taper like branches, as thick as the length of everything they
/// carry (Leonardo's rule), and a head.
std::vector<DrawnBone> figure_shape(const Skeleton& skeleton);

/// The horizontal unit vector in which the figure faces, judged by where its legs join the trunk.
/// World z for a figure without legs. `points` are the landmarks of one frame, y up.
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
  std::string review;  // the script of review_clip() for review_name(); empty: without the viewer
};

/// One frame of the original and of each method.
struct PicturedFrame {
  int frame = 0;
  PosePoints original;
  std::vector<PosePoints> decoded;  // one for each method
};

/// The contact with the largest slide in the first method.
struct PicturedFoot {
  int landmark = 0;
  PicturedFrame pose;  // at the end of the contact
  std::vector<Eigen::Vector3d> original_trail;
  std::vector<std::vector<Eigen::Vector3d>> trails;  // one for each method
  std::vector<double> slid_cm;                       // for each method, in excess of the original
};

/// A clip compressed by several methods to one ratio, in selected poses.
struct Picture {
  std::string clip;  // path
  double ratio = 0;  // same for every method
  double sample_rate_hz = 120;
  int frames = 0;
  std::vector<DrawnBone> bones;
  std::vector<std::string> landmark_names;
  double ground_cm = 0;    // height of the floor
  Eigen::Vector3d facing;  // in the worst frame
  std::vector<PicturedMethod> methods;
  PicturedFrame worst;                  // largest error of the first method
  std::vector<PicturedFrame> sequence;  // at even distances over the clip
  std::optional<PicturedFoot> foot;     // unset: no foot slides
};

/// The name under which a page shows a pictured clip, compressed by one method: it has the clip's
/// whole path, for clips of two folders may be called alike.
std::string review_name(const Picture& picture, const std::string& method);

}  // namespace mocapress
