// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// Returns a whole number of steps, near value / step, from which a decoder in floats makes the
/// same value at every frame of a clip of any length. Predictions from equal neighbours are rounded
/// sums of rounded products, which give back the neighbours' value for most numbers, but not for
/// all. Takes the nearest number within 64 steps for which they do; if there is none, the nearest
/// whole number.
int steps_of_constant(double value, double step);

}  // namespace mocapress
