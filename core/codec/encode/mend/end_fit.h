// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/options/encode_settings.h"
#include "core/codec/encode/search/goal.h"

namespace mocapress {

/// Returns whether an encoding gets the section ENDS: closed loops do, unless ends are free. A hard
/// maximum already holds at the ends; with it as the target, only loops and exact ends get the
/// section. Drafts must be quick, so they get it for exact ends only.
bool codes_ends(const EncodeSettings& settings);

/// The number of frames at either end that the fit looks at. The correction of an end may fade out
/// over as many.
int frames_at_ends(int frames);

/// Codes corrections of a trial's first and last pose, in the fewest bits that keep the promise. It
/// corrects only a few channels if these suffice. The error of an even end is at most 0.9 of the
/// target, that of an exact end at most a tenth. If the target is no error, the trial's own error
/// takes its place. In a loop the last pose gets the first one's error in channels, or as much of
/// it as keeps the promise, to within a tenth of the target, so that nothing jumps at the seam. The
/// numbers of frames over which the corrections fade out are chosen so that the velocity changes
/// little at the seam. If it still changes by more than at any other frame, a correction of the
/// last velocity is coded too. With an IK correction both ends are exact and no other frame is
/// changed, since held feet would slide otherwise. The originals are the first and last frames in
/// the coded channels: frames_at_ends() of them, at least one. Channels that stand still in the
/// clip are left alone.
void fit_ends(const EncodeSettings& settings, Trial& trial, const Skeleton& coded_skeleton,
              const std::vector<bool>& still, const Goal& goal,
              const Eigen::MatrixXd& original_first, const Eigen::MatrixXd& original_last);

}  // namespace mocapress
