// SPDX-License-Identifier: MIT
#include "core/formats/material_colour.h"

#include <algorithm>
#include <cmath>

#include "core/motion/skin.h"

namespace mocapress {

Eigen::Vector3f material_colour(const Eigen::Vector3f& linear) {
  constexpr float kWhite = 0.99F;
  if (!linear.allFinite() || linear.minCoeff() >= kWhite) return kPlainSkin;
  // IEC 61966-2-1.
  return linear.unaryExpr([](float value) {
    const float in_range = std::clamp(value, 0.0F, 1.0F);
    return in_range <= 0.0031308F ? 12.92F * in_range
                                  : 1.055F * std::pow(in_range, 1 / 2.4F) - 0.055F;
  });
}

}  // namespace mocapress
