// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/motion/clip.h"
#include "resources/samples/generator/performer.h"

namespace mocapress::samples {

/// From standing, a few strides along an arc, and to a stop.
Choreography walk();
/// Part of a steady run along an arc.
Choreography run();
/// A jump forward and a higher one on the spot.
Choreography jump();

Motion walk_clip();
Motion run_clip();
Motion jump_clip();

/// human.asf, human_walk.amc, human_run.amc and human_jump.amc. Throws WriteError.
void write_samples(const std::filesystem::path& folder);

}  // namespace mocapress::samples
