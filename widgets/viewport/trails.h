// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/viewport/figure_shape.h"

namespace mocapress {

/// The path of a landmark around a frame, `reach` frames to each side. It is thinner the further
/// away in time. `radius` is in cm.
std::vector<Capsule> jointPath(const Eigen::MatrixXd& tracks, int landmark, int frame, int reach,
                               float radius);

/// Selects the poses that are drawn around the current frame. Their frames are multiples of `step`,
/// so that they stand still while the figure walks through them.
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

/// The capsules of the selected poses. They show only body parts, since many poses are drawn at
/// once. `tracks`: frames x 3 * landmarks, cm.
std::vector<Capsule> ghostTrail(const FigureShape& shape, const Eigen::MatrixXd& tracks,
                                const TrailPoses& poses, const TrailColours& colours);

/// The drift at a frame of each joint that slides, as FigureMarks::alerts from 0 to 1.
std::vector<float> slideAlerts(const std::vector<SlideFinding>& slides, int joints, int frame);

/// The path of each sliding point during its contact, projected to the ground (y = 0). `tracks` are
/// those of the sliding figure; `radius` is in cm.
std::vector<Capsule> slideTrails(const std::vector<SlideFinding>& slides,
                                 const Eigen::MatrixXd& tracks, float radius);

/// A ball under each point that stands on the ground at a frame, coloured by its drift; the scene
/// flattens it to a disc. Positions are taken from `tracks`.
std::vector<Capsule> footDiscs(const std::vector<ContactSpan>& contacts,
                               const std::vector<SlideFinding>& slides,
                               const Eigen::MatrixXd& tracks, int frame, float radius);

}  // namespace mocapress
