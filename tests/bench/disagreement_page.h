// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/batch/worst_pose.h"
#include "core/report/sight_chart.h"

namespace mocapress {

/// A compressed clip in pictures: its error over time, the visibility of errors, and two poses.
struct LookedAt {
  std::string title;
  std::string figures;  // in a few words
  std::string reason;   // reason for the verdict
  double seconds = 0;
  Eigen::VectorXd rms_cm;  // RMS of every frame, on the body's surface
  Eigen::VectorXd max_cm;
  SightChart sights;
  WorstPose furthest;   // frame with the largest error at a bone end
  WorstPose most_seen;  // frame with the most visible error
};

/// Two clips that two figures rank in opposite order.
struct Disagreement {
  std::string title;
  LookedAt better;  // better by the first figure
  LookedAt worse;
};

/// A self-contained HTML page.
std::string disagreement_page(const std::vector<Disagreement>& all);

}  // namespace mocapress
