// SPDX-License-Identifier: MIT
#pragma once

#include "resources/samples/generator/foot_plan.h"
#include "resources/samples/generator/posture.h"

namespace mocapress::samples {

/// Bends hip, knee, foot and toes so that the foot is where and as `foot` says: six angles for six
/// conditions, in closed form. A foot out of reach is met in direction only.
void place_foot(Posture& posture, Side side, const FootState& foot);

/// The distance from hip to ankle (cm) with the knee flexed by that much.
double leg_length(double knee_degrees);

}  // namespace mocapress::samples
