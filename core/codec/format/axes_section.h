// SPDX-License-Identifier: MIT
// Joints whose coded angles are about turned axes: FORMAT.md, AXES.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/motion/rotation_form.h"
#include "core/runtime/format/section.h"

namespace mocapress {

inline constexpr std::string_view kAxes = "AXES";

/// Returns whether a joint may have fixed turns: it must have a parent and turn freely.
bool may_turn_axes(const Joint& joint);

/// The section for a coded skeleton; empty if no axes are turned.
std::size_t axes_section_bytes(const Skeleton& coded);

/// The payload of AXES.
std::vector<std::byte> write_axes(const Skeleton& skeleton, const RotationForms& forms);

/// Sets the fixed turns of the forms. Throws FormatError.
void read_axes(const runtime::Bytes& axes, const Skeleton& skeleton, RotationForms& forms);

}  // namespace mocapress
