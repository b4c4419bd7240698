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
  int from;  // landmarks
  int to;
  double from_radius;  // cm
  double to_radius;
};

/// A body for a skeleton: limbs that taper as trees do, each as thick as all that it carries is
/// long (Leonardo's rule), and a head.
std::vector<DrawnBone> figure_shape(const Skeleton& skeleton);

/// Where the figure faces, horizontal and of length 1, from where its legs join the trunk. World z
/// when it has no legs to tell. `points` are the landmarks of one frame, y up.
Eigen::Vector3d facing(const Skeleton& skeleton, const std::vector<Eigen::Vector3d>& points);

/// World positions (cm) of all landmarks at one frame.
using PosePoints = std::vector<Eigen::Vector3d>;

/// One compression of the pictured clip.
struct PicturedMethod {
  std::string method;
  double ratio = 0;
  double eps_cm = 0;
  double max_error_cm = 0;
  SightChart sights;
};

/// One frame, as it was and as each method left it.
struct PicturedFrame {
  int frame = 0;
  PosePoints original;
  std::vector<PosePoints> decoded;  // one a method
};

/// The contact in which the first method let a foot slide most.
struct PicturedFoot {
  int landmark = 0;
  PicturedFrame pose;  // at the end of the contact
  std::vector<Eigen::Vector3d> original_trail;
  std::vector<std::vector<Eigen::Vector3d>> trails;  // one a method
  std::vector<double> slid_cm;                       // one a method, beyond the original's own
};

/// A clip compressed by several methods to one ratio, in poses worth looking at.
struct Picture {
  std::string clip;  // path
  double ratio = 0;  // asked of every method
  double sample_rate_hz = 120;
  int frames = 0;
  std::vector<DrawnBone> bones;
  std::vector<std::string> landmark_names;
  double ground_cm = 0;    // height of the floor
  Eigen::Vector3d facing;  // at the worst frame
  std::vector<PicturedMethod> methods;
  PicturedFrame worst;                  // where the first method is furthest off
  std::vector<PicturedFrame> sequence;  // evenly over the clip
  std::optional<PicturedFoot> foot;     // unset: no foot slides
};

}  // namespace mocapress
