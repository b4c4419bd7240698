// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/motion/body_tracks.h"

namespace mocapress {

/// Some frames of body_tracks(), where they stand.
using TrackRows = Eigen::Ref<const Eigen::MatrixXd>;

/// body_tracks() of some frames: those of `first_frame` and after.
using TrackBlock = std::function<void(int first_frame, const Eigen::MatrixXd& tracks)>;

/// Visits body_tracks() of a clip in time: all at once or, of a long clip, some thousand frames
/// at a time, so that they are never all in memory.
void visit_tracks(const Skeleton& skeleton, const Clip& clip, const TrackBlock& visit);

}  // namespace mocapress
