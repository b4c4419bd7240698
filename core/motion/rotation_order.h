// SPDX-License-Identifier: MIT
// The orders in which three angles can make a rotation. None suits all motion: where the middle
// angle comes near a right one, the outer two turn about one axis and jump.
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

/// Of each joint; what the ones that do not turn freely have here says nothing.
using RotationOrders = std::vector<RotationOrder>;

RotationOrders rotation_orders(const Skeleton& skeleton);

/// The skeleton with the rotation channels of its joints in other orders, in the same places among
/// the channels. `orders`: one for each joint.
Skeleton with_orders(const Skeleton& skeleton, const RotationOrders& orders);

/// The same motion in the channels of with_orders(): continuous over time, and beginning with the
/// middle angle within a right one of zero or, of a part of a motion, near the angles given.
Motion with_orders(const Motion& motion, const RotationOrders& orders);
Motion with_orders(const Motion& motion, const RotationOrders& orders,
                   const Eigen::Matrix3Xd& first_angles);

/// Angles, in radians, of each joint (3 x joints) at some frames of with_orders(), which are to be
/// in time. What parts that begin there have to begin with.
std::vector<Eigen::Matrix3Xd> angles_at(const Motion& motion, const RotationOrders& orders,
                                        const std::vector<int>& frames);

}  // namespace mocapress
