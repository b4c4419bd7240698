// SPDX-License-Identifier: MIT
// All of the library: read a motion, compress it, measure the result, play it.
//
//   MotionFile walk = read_motion("walk.bvh");
//   Settings settings = settings_from_json(R"({"target": {"kind": "error", "value": 0.5}})");
//   Encoded made = encode(walk, settings);
//   LocalPose pose = Player(made.file).sample(0.5);
#pragma once

#include "core/mocapress/encode.h"
#include "core/mocapress/measure.h"
#include "core/mocapress/motion.h"
#include "core/mocapress/player.h"
#include "core/mocapress/settings.h"
