// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

namespace mocapress {

/// The natural cubic spline through `values` at rising `frames`, at every frame from the first of
/// them to the last.
Eigen::VectorXd natural_spline(std::span<const int> frames,
                               const Eigen::Ref<const Eigen::VectorXd>& values);

}  // namespace mocapress
