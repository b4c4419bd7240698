// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

namespace mocapress {

/// What one degree of freedom moves. The values are part of the file format: never reassign one.
enum class ChannelKind : std::uint8_t {
  TranslationX = 0,  // cm
  TranslationY = 1,
  TranslationZ = 2,
  RotationX = 3,  // radians
  RotationY = 4,
  RotationZ = 5,
};

inline constexpr int kChannelKinds = 6;

constexpr bool is_rotation(ChannelKind kind) {
  return kind >= ChannelKind::RotationX;
}

/// 0, 1, 2 for X, Y, Z.
constexpr int axis_of(ChannelKind kind) {
  return static_cast<int>(kind) % 3;
}

constexpr ChannelKind translation_about(int axis) {
  return static_cast<ChannelKind>(axis);
}
constexpr ChannelKind rotation_about(int axis) {
  return static_cast<ChannelKind>(3 + axis);
}

/// "tx" ... "rz".
std::string_view short_name(ChannelKind kind);

/// The rotation by `radians` about coordinate axis 0, 1 or 2.
Eigen::Matrix3d axis_rotation(int axis, double radians);

}  // namespace mocapress
