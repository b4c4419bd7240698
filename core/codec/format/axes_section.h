// SPDX-License-Identifier: MIT
// The section AXES of a .mcpr file (FORMAT.md): joints whose coded angles are about turned axes.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/motion/rotation_form.h"
#include "core/runtime/format/section.h"

namespace mocapress {

inline constexpr std::string_view kAxes = "AXES";

/// Returns whether a joint's axes may be turned: it must have a parent and turn freely.
bool may_turn_axes(const Joint& joint);

/// The size of the payload of AXES for a coded skeleton; 0 if no axes are turned.
std::size_t axes_section_bytes(const Skeleton& coded);

/// The payload of AXES.
std::vector<std::byte> write_axes(const Skeleton& skeleton, const RotationForms& forms);

/// Reads the payload of AXES into the fixed turns of `forms`. Throws FormatError.
void read_axes(const runtime::Bytes& axes, const Skeleton& skeleton, RotationForms& forms);

}  // namespace mocapress
