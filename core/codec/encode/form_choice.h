// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/rotation_form.h"

namespace mocapress {

/// For each joint the form of its rotations that is likely to take fewest bits, by what the wavelet
/// coefficients of its angles come to on some of the frames: of the six orders, and of two about
/// axes turned so that the innermost angle is the twist of what hangs on the joint. Joints that
/// mirror one another choose alike. Its own where no other saves much.
RotationForms choose_forms(const Motion& motion);

}  // namespace mocapress
