// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// The inner product of `count` numbers, a multiple of eight, by the machine's best instruction
/// set.
float inner_product(const float* a, const float* b, Eigen::Index count);

}  // namespace mocapress
