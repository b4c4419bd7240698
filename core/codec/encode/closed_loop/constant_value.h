// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// Returns a whole number of steps, near value / step, from which a decoder in floats makes the
/// same value at every frame of a clip of any length. The decoder predicts samples from their
/// neighbours by rounded sums of rounded products. If all neighbours are equal, these give back the
/// neighbours' value for most numbers, but not for all. Returns the nearest number within 64 steps
/// for which they do; if there is none, the nearest whole number.
int steps_of_constant(double value, double step);

}  // namespace mocapress
