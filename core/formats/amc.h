// SPDX-License-Identifier: MIT
// Acclaim motion: the values of an .asf's degrees of freedom, frame by frame.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/asf.h"
#include "core/formats/motion_file.h"

namespace mocapress {

inline constexpr double kUsualAmcRate = 120;  // Hz: CMU's rate, since their files state none

/// Reads the text of an .amc; `file` names it in messages. Bones that the first frame leaves out
/// have no channels. Throws InputError.
///
/// Three values on a bone with fewer dof turn it by Rz * Ry * Rx. With the header
/// FORCE-ALL-JOINTS-BE-3DOF the values belong to its dof, then to the missing axes (CMU's wrists
/// are continuous only in this reading). Without the header the values are rx ry rz.
MotionFile read_amc(const std::string& file, std::string_view text, const AsfSkeleton& skeleton,
                    const ReadOptions& options = {});

/// The text of an .amc, in degrees and asf_text()'s unit of length. Requires a motion that
/// acclaim_motion() returned.
std::string amc_text(const Motion& motion, double cm_per_unit = kAsfCmPerUnit);

}  // namespace mocapress
