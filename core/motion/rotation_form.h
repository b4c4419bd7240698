// SPDX-License-Identifier: MIT
// The forms in which three angles can make a rotation. None suits all motion: where the middle
// angle comes near a right one, the outer two turn about one axis and jump; and a limb whose twist
// is an angle of its own needs few bits for that.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// Axes of a joint's rotation channels from the left. The values are part of the file format.
enum class RotationOrder : std::uint8_t { Xyz, Xzy, Yxz, Yzx, Zxy, Zyx };

inline constexpr int kRotationOrders = 6;

/// 0 1 2: x y z.
std::array<int, 3> axes_of(RotationOrder order);

/// What the order of the joint's rotation channels is; requires turns_freely().
RotationOrder rotation_order(const Joint& joint);

/// Whether a joint has three rotation channels about three different axes.
bool turns_freely(const Joint& joint);

/// A rotation that stays: axis times angle, x y z in units of pi / 16, each -16 .. 15.
using FixedTurn = std::array<std::int8_t, 3>;

inline constexpr int kFixedTurns = 16;  // in half a turn

Eigen::Matrix3d rotation_of(const FixedTurn& turn);

/// About the rotation: most are within 10 degrees of it.
FixedTurn fixed_turn_near(const Eigen::Matrix3d& rotation);

/// R = before * (three angles about coordinate axes) * after.
struct RotationForm {
  RotationOrder order = RotationOrder::Xyz;
  FixedTurn before{};
  FixedTurn after{};

  bool has_fixed_turns() const { return before != FixedTurn() || after != FixedTurn(); }
  bool operator==(const RotationForm&) const = default;
};

/// Of each joint; what the ones that do not turn freely have here says nothing.
using RotationForms = std::vector<RotationForm>;

/// Of the skeleton of a source: orders alone.
RotationForms rotation_forms(const Skeleton& skeleton);

/// The skeleton with the rotation channels of its joints in other forms, in the same places among
/// the channels. `forms`: one for each joint.
Skeleton with_forms(const Skeleton& skeleton, const RotationForms& forms);

/// The same motion in the channels of with_forms(): continuous over time, and beginning with the
/// middle angle within a right one of zero or, of a part of a motion, near the angles given.
Motion with_forms(const Motion& motion, const RotationForms& forms);
Motion with_forms(const Motion& motion, const RotationForms& forms,
                  const Eigen::Matrix3Xd& first_angles);

/// Angles, in radians, of each joint (3 x joints) at some frames of with_forms(), which are to be
/// in time. What parts that begin there have to begin with.
std::vector<Eigen::Matrix3Xd> angles_at(const Motion& motion, const RotationForms& forms,
                                        const std::vector<int>& frames);

}  // namespace mocapress
