// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/axes_section.h"

namespace mocapress::test {

/// Turned axes for every joint that may have them.
inline RotationForms turned_forms(const Skeleton& skeleton) {
  RotationForms forms = rotation_forms(skeleton);
  for (std::size_t j = 0; j < forms.size(); ++j)
    if (may_turn_axes(skeleton.joints()[j])) {
      forms[j].before = {-16, 15, static_cast<std::int8_t>(j)};
      forms[j].after = {1, 0, -2};
    }
  return forms;
}

}  // namespace mocapress::test
