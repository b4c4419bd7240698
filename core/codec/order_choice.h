// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/rotation_order.h"

namespace mocapress {

/// For each joint the order of rotations that is likely to take fewest bits: of the six, by what
/// the wavelet coefficients of its angles come to on some of the frames. Joints that mirror one
/// another get the same. Its own where no other saves much.
RotationOrders choose_orders(const Motion& motion);

}  // namespace mocapress
