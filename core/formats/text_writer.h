// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <unordered_set>

namespace mocapress {

/// Appends `value` with at most `decimals` digits after the point and no zeros at the end.
void append_number(std::string& text, double value, int decimals = 6);

/// How many decimals a length needs in a unit of so many centimetres, to be exact to some 1e-6 cm.
int length_decimals(double cm_per_unit);

/// Appends " x y z".
void append_vector(std::string& text, const Eigen::Vector3d& vector, int decimals = 6);

/// "1 bone", "2 bones".
std::string counted(long count, const std::string& noun);

/// A name for a message: its first 40 bytes.
std::string shortened(const std::string& name);

/// The name with white space, control characters and any of `forbidden` replaced by '_'; never
/// empty.
std::string as_word(const std::string& name, const std::string& forbidden);

/// `name`, or `name` with a number where it is taken already. Takes it.
std::string unique_word(const std::string& name, std::unordered_set<std::string>& taken);

}  // namespace mocapress
