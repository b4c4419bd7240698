// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/rotation_form.h"

namespace mocapress {

/// Chooses for each joint the form of its rotations that is likely to take the fewest bits, judged
/// by wavelet coefficients of its angles on some of the frames. The candidates are the six orders
/// and two forms with turned axes, whose innermost angle is the twist of the limb below the joint.
/// Joints that mirror one another get the same form. A joint keeps its own form unless another
/// saves at least 2 %.
RotationForms choose_forms(const Motion& motion);

}  // namespace mocapress
