// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/viewport/figure_shape.h"

namespace mocapress {

/// How badly each joint slides at a frame, 0 ... 1: FigureMarks::alerts.
std::vector<float> slideAlerts(const std::vector<SlideFinding>& slides, int joints, int frame);

/// The way of each sliding point over the ground while it should stand, drawn on y = 0. `tracks` of
/// the figure that slides, `radius` in cm.
std::vector<Capsule> slideTrails(const std::vector<SlideFinding>& slides,
                                 const Eigen::MatrixXd& tracks, float radius);

/// A ball under each point that stands on the ground at a frame, to be pressed flat, in the colour
/// of how far it slides. Where each stands is taken from `tracks`.
std::vector<Capsule> footDiscs(const std::vector<ContactSpan>& contacts,
                               const std::vector<SlideFinding>& slides,
                               const Eigen::MatrixXd& tracks, int frame, float radius);

}  // namespace mocapress
