// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Of so many numbers, a multiple of eight, in the instruction set that the machine has.
float inner_product(const float* a, const float* b, Eigen::Index count);

}  // namespace mocapress
