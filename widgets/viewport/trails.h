// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/viewport/figure_shape.h"

namespace mocapress {

/// The way of a landmark around a frame, `reach` frames to either side, thinner the further away in
/// time. `radius` in cm.
std::vector<Capsule> jointPath(const Eigen::MatrixXd& tracks, int landmark, int frame, int reach,
                               float radius);

/// Which poses around now are drawn: those at whole multiples of `step`, so that they stand still
/// while the figure walks through them.
struct TrailPoses {
  int frame = 0;  // now
  int step = 1;   // frames
  int count = 0;  // before now, and after

  /// In the order of time, without now.
  std::vector<int> frames(int clip_frames) const;
};

struct TrailColours {
  QColor past;
  QColor future;
  QColor far;  // what the poses fade to with their distance in time
};

/// Those poses of a figure, its bones alone: many poses are drawn at once. tracks: frames x 3 *
/// landmarks, cm.
std::vector<Capsule> ghostTrail(const FigureShape& shape, const Eigen::MatrixXd& tracks,
                                const TrailPoses& poses, const TrailColours& colours);

/// Each joint's slide at a frame, by its drift, 0 ... 1: FigureMarks::alerts.
std::vector<float> slideAlerts(const std::vector<SlideFinding>& slides, int joints, int frame);

/// The way of each sliding point over the ground while it should stand, drawn on y = 0. `tracks` of
/// the figure that slides, `radius` in cm.
std::vector<Capsule> slideTrails(const std::vector<SlideFinding>& slides,
                                 const Eigen::MatrixXd& tracks, float radius);

/// A ball under each point that stands on the ground at a frame, to be pressed flat, in the colour
/// of how far it drifts. Where each stands is taken from `tracks`.
std::vector<Capsule> footDiscs(const std::vector<ContactSpan>& contacts,
                               const std::vector<SlideFinding>& slides,
                               const Eigen::MatrixXd& tracks, int frame, float radius);

}  // namespace mocapress
