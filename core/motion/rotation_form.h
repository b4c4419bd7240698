// SPDX-License-Identifier: MIT
// The forms in which three angles can make a rotation. None suits all motion. If the middle angle
// comes near a right angle, the outer two turn about nearly the same axis and jump. A limb whose
// twist is an angle of its own needs few bits for it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// Axes of a joint's rotation channels from the left. The values are part of the file format.
enum class RotationOrder : std::uint8_t { Xyz, Xzy, Yxz, Yzx, Zxy, Zyx };

inline constexpr int kRotationOrders = 6;

/// Axes in this order, as 0, 1, 2 for x, y, z.
std::array<int, 3> axes_of(RotationOrder order);

/// The order of the joint's rotation channels. Requires turns_freely().
RotationOrder rotation_order(const Joint& joint);

/// True if a joint has three rotation channels about three different axes.
bool turns_freely(const Joint& joint);

/// A constant rotation: axis times angle, x y z in units of pi / 16, each -16 .. 15.
using FixedTurn = std::array<std::int8_t, 3>;

inline constexpr int kFixedTurns = 16;  // steps in half a turn

Eigen::Matrix3d rotation_of(const FixedTurn& turn);

/// The fixed turn nearest to a rotation, mostly within 10 degrees of it.
FixedTurn fixed_turn_near(const Eigen::Matrix3d& rotation);

/// A form of a joint's rotation: R = before * (rotations by three angles about coordinate axes) *
/// after.
struct RotationForm {
  RotationOrder order = RotationOrder::Xyz;
  FixedTurn before{};
  FixedTurn after{};

  bool has_fixed_turns() const { return before != FixedTurn() || after != FixedTurn(); }
  bool operator==(const RotationForm&) const = default;
};

/// One form for each joint. Forms of joints that do not turn freely have no meaning.
using RotationForms = std::vector<RotationForm>;

/// The forms that a source's skeleton has: rotation orders, without fixed turns.
RotationForms rotation_forms(const Skeleton& skeleton);

/// The skeleton with its joints' rotation channels in other forms, at the same places among the
/// channels. `forms`: one for each joint.
Skeleton with_forms(const Skeleton& skeleton, const RotationForms& forms);

/// The same motion in the channels of with_forms(), continuous over time. In its first frame,
/// middle angles are within a right angle of zero; a part of a motion can begin near the angles
/// given instead.
Motion with_forms(const Motion& motion, const RotationForms& forms);
Motion with_forms(const Motion& motion, const RotationForms& forms,
                  const Eigen::Matrix3Xd& first_angles);

/// Angles (radians) of each joint, 3 x joints, at some frames of with_forms(), in order of time. A
/// part of the motion that begins at one of these frames takes them as its first angles.
std::vector<Eigen::Matrix3Xd> angles_at(const Motion& motion, const RotationForms& forms,
                                        const std::vector<int>& frames);

}  // namespace mocapress
