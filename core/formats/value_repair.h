// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace mocapress {

/// Values as in a file: frames x columns, row by row; NaN marks a missing one.
using RawRows = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Replaces values that no motion can hold (NaN, infinities, values beyond 1e9) by the value of the
/// frame before; in the first frame by the first good one after, or 0. Returns their number.
long repair_values(RawRows rows);

// Warnings about a file that lacks a part of its motion.
inline constexpr const char* kRepaired = " not finite or beyond 1e9, replaced by the frame before";
inline constexpr const char* kTruncated = "the file ends within its last frame, which is dropped";
inline constexpr const char* kOtherFrames = " follow: all of them are read";
inline constexpr const char* kRepeated =
    " missing from a frame, where the frame before is repeated";
inline constexpr const char* kKeysLeftOut = " left out: not a finite number";

/// True if a warning's text tells of such damage, false if it tells of a guess.
bool tells_of_damage(std::string_view warning);

}  // namespace mocapress
