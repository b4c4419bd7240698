// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/encoder.h"
#include "core/codec/encode/trial.h"

namespace mocapress {

/// Whether ENDS is asked for: of a closed loop, and not where a hard maximum holds anyway or a
/// draft, which promises nothing, has to be there at once.
bool codes_ends(const EncodeOptions& options);

/// How many frames at either end are looked at, to see how far an end's error reaches.
int frames_at_ends(int frames);

/// Codes what the first and the last pose of a trial lack, in the coarsest steps that keep the
/// promise: of an even end 0.8 of the target, so that neighbours fare well too, of an exact one a
/// tenth; of what the trial has where the target is no error. The last pose of a loop comes to a
/// tenth of the target as near to the first's error, so that nothing jumps, and velocities as near
/// as may be. Beside a correction ends are exact and no other frame takes part, or feet that are
/// held would slide. The originals are in the channels that are coded: as many first and last
/// frames as frames_at_ends() says, at least one.
void fit_ends(const EncodeOptions& options, Trial& trial, const Skeleton& coded_skeleton,
              const Eigen::MatrixXd& original_first, const Eigen::MatrixXd& original_last);

}  // namespace mocapress
