// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/error.h"
#include "core/motion/clip.h"

namespace mocapress {

/// What a file does not say. Unset values are guessed, and the guess is a warning.
struct ReadOptions {
  std::optional<double> sample_rate_hz;  // AMC states none: 120 Hz, the CMU rate, unless given
  std::optional<double> cm_per_unit;     // BVH states none: guessed from the height of the skeleton
};

/// A motion as read, with what had to be repaired or guessed.
struct MotionFile {
  Motion motion;  // cm, radians (unwrapped), seconds
  Warnings warnings;
};

/// The .asf beside an .amc, of the same name or of the part before '_' (09_01.amc: 09_01.asf,
/// 09.asf), whatever the case of the extension. Throws InputError when there is none.
std::filesystem::path find_skeleton(const std::filesystem::path& amc);

/// Reads .bvh or .amc by its extension. An .amc needs its skeleton: `skeleton_path`, or else what
/// find_skeleton() finds. Throws InputError.
MotionFile read_motion(const std::filesystem::path& path,
                       const std::optional<std::filesystem::path>& skeleton_path = {},
                       const ReadOptions& options = {});

/// Writes .bvh, .csv, or .amc with the skeleton at `skeleton_path` (by default beside the .amc,
/// same name, extension .asf), by the extension of `path`. Throws WriteError; Error on an unknown
/// extension.
void write_motion(const std::filesystem::path& path, const Motion& motion,
                  const std::optional<std::filesystem::path>& skeleton_path = {});

}  // namespace mocapress
