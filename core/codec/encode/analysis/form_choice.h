// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/rotation_form.h"

namespace mocapress {

/// For each joint the form of its rotations that is likely to take the fewest bits. The wavelet
/// coefficients of its angles on some of the frames tell. The choice is among the six orders and
/// two forms about turned axes, whose innermost angle is the twist of the limb below the joint.
/// Joints that mirror one another choose alike. A joint keeps its own form where no other saves
/// much.
RotationForms choose_forms(const Motion& motion);

}  // namespace mocapress
