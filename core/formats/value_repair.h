// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Values as in a file: frames x columns, row by row; NaN marks a missing one.
using RawRows = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Replaces values that no motion can hold (NaN, infinities, values beyond 1e9) by the value of the
/// frame before; in the first frame by the first good one after, or 0. Returns their number.
long repair_values(RawRows rows);

/// The text of a warning, after their number.
inline constexpr const char* kRepaired = " not finite or beyond 1e9, replaced by the frame before";

}  // namespace mocapress
