// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

namespace mocapress {

/// Appends `value` with at most `decimals` digits after the point and no zeros at the end.
void append_number(std::string& text, double value, int decimals = 6);

/// Appends " x y z".
void append_vector(std::string& text, const Eigen::Vector3d& vector, int decimals = 6);

/// "1 bone", "2 bones".
std::string counted(long count, const std::string& noun);

/// The name with white space, control characters and any of `forbidden` replaced by '_'; never
/// empty.
std::string as_word(const std::string& name, const std::string& forbidden);

}  // namespace mocapress
