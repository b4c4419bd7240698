// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/viewport/figure_shape.h"

namespace mocapress {

/// The path of a landmark around a frame, `reach` frames to each side, thinner the further away in
/// time. `radius` in cm.
std::vector<Capsule> jointPath(const Eigen::MatrixXd& tracks, int landmark, int frame, int reach,
                               float radius);

/// Selects the poses that are drawn around the current frame: whole multiples of `step`, so that
/// they stand still while the figure walks through them.
struct TrailPoses {
  int frame = 0;  // current frame
  int step = 1;   // frames
  int count = 0;  // poses before the current frame, and as many after

  /// The poses' frames in order, without the current one.
  std::vector<int> frames(int clip_frames) const;
};

struct TrailColours {
  QColor past;
  QColor future;
  QColor far;  // colour at the greatest distance in time
};

/// Capsules of those poses, bones only, since many are drawn at once. tracks: frames x 3 *
/// landmarks, cm.
std::vector<Capsule> ghostTrail(const FigureShape& shape, const Eigen::MatrixXd& tracks,
                                const TrailPoses& poses, const TrailColours& colours);

/// The drift of each joint that slides at a frame, 0 to 1, as FigureMarks::alerts.
std::vector<float> slideAlerts(const std::vector<SlideFinding>& slides, int joints, int frame);

/// The path of each sliding point over the ground during its contact, drawn on y = 0. `tracks` is
/// the sliding figure, `radius` in cm.
std::vector<Capsule> slideTrails(const std::vector<SlideFinding>& slides,
                                 const Eigen::MatrixXd& tracks, float radius);

/// A ball, later flattened, under each point that stands on the ground at a frame, coloured by its
/// drift. Positions come from `tracks`.
std::vector<Capsule> footDiscs(const std::vector<ContactSpan>& contacts,
                               const std::vector<SlideFinding>& slides,
                               const Eigen::MatrixXd& tracks, int frame, float radius);

}  // namespace mocapress
