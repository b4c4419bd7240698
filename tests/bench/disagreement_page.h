// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/batch/worst_pose.h"
#include "core/report/sight_chart.h"

namespace mocapress {

/// A compressed clip as one looks at it: its error over time, what the eye sees, and two poses.
struct LookedAt {
  std::string title;
  std::string figures;  // in a few words
  std::string reason;   // of the verdict
  double seconds = 0;
  Eigen::VectorXd rms_cm;  // of every frame, on the body's surface
  Eigen::VectorXd max_cm;
  SightChart sights;
  WorstPose furthest;   // where a bone end is furthest off
  WorstPose most_seen;  // where the eye sees most
};

/// Two clips that two figures put in contrary order.
struct Disagreement {
  std::string title;
  LookedAt better;  // by the first figure
  LookedAt worse;
};

/// An HTML page that needs nothing else.
std::string disagreement_page(const std::vector<Disagreement>& all);

}  // namespace mocapress
