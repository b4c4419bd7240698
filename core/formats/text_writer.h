// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <unordered_set>

namespace mocapress {

/// Appends `value` with at most `decimals` digits after the point, without trailing zeros.
void append_number(std::string& text, double value, int decimals = 6);

/// The decimals that a length needs in a unit of `cm_per_unit`, to be exact to about 1e-6 cm.
int length_decimals(double cm_per_unit);

/// Appends " x y z".
void append_vector(std::string& text, const Eigen::Vector3d& vector, int decimals = 6);

/// "1 bone", "2 bones".
std::string counted(std::int64_t count, const std::string& noun);

/// The name with white space, control characters and any of `forbidden` replaced by '_'; never
/// empty.
std::string as_word(const std::string& name, const std::string& forbidden);

/// `name`, with a number if it is taken already. Adds the result to `taken`.
std::string unique_word(const std::string& name, std::unordered_set<std::string>& taken);

}  // namespace mocapress
