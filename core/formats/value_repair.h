// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Values as they stand in a file: frames x columns, row by row; NaN where one is missing.
using RawRows = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Replaces what no motion can hold (NaN, infinities, values beyond 1e9) by the value of the frame
/// before; in the first frame by the first good one after, or 0. Returns how many there were.
long repair_values(RawRows rows);

/// What to say of them, after their number.
inline constexpr const char* kRepaired = " not finite or beyond 1e9, replaced by the frame before";

}  // namespace mocapress
