// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// The colour of a material as screens have it (sRGB), from linear red, green and blue. Pure white
/// is what files say where a picture has the colours: that becomes kPlainSkin.
Eigen::Vector3f material_colour(const Eigen::Vector3f& linear);

}  // namespace mocapress
