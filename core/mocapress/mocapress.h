// SPDX-License-Identifier: MIT
// All of the library: read a motion, compress it, measure what that cost, play it.
//
//   MotionFile walk = read_motion("walk.bvh");
//   Encoded made = encode(walk, settings_from_json(R"({"target": {"kind": "error", "value":
//   0.5}})")); LocalPose pose = Player(made.file).sample(0.5);
#pragma once

#include "core/mocapress/encode.h"
#include "core/mocapress/measure.h"
#include "core/mocapress/motion.h"
#include "core/mocapress/player.h"
#include "core/mocapress/settings.h"
