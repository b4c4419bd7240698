// SPDX-License-Identifier: MIT
#include "resources/samples/generator/gait.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::samples {

Choreography walk() {
  Gait gait{};
  gait.seconds = 6;
  gait.speed = 126;
  gait.start = 0.35;
  gait.start_duration = 1.0;
  gait.stop = 4.25;
  gait.stop_duration = 1.1;
  gait.curvature = 0.0012;
  gait.arc_middle = 250;
  gait.first_liftoff = 0.65;
  gait.step_duration = 0.54;
  gait.swing_duration = 0.42;
  gait.steps = 9;
  gait.print_behind = 8;
  gait.half_step_width = 5;
  gait.half_standing_width = 8.5;
  gait.toe_out = 7;
  gait.touchdown_pitch = -19;
  gait.liftoff_pitch = 58;
  gait.liftoff_toe_pitch = 18;
  gait.settling = 0.12;
  gait.heel_rise = 0.33;
  gait.toe_rise = 0.07;
  gait.swing = {
      {0.30, 0.36, 12.5, 44, 30}, {0.62, 0.81, 3.4, -4, -10}, {0.88, 1.04, 3.2, -19, -24}};
  gait.swing_out = 0.8;
  gait.centre_of = Centre::Root;
  gait.centre_height = kStandingRootHeight - 1.3;
  gait.sway = 0.45;
  gait.lean = 4;
  gait.pelvis_turn = 5;
  gait.pelvis_drop = 3.5;
  gait.chest_turn = 9;
  gait.arm_swing = 19;
  gait.elbow = 22;
  gait.elbow_swing = 11;
  gait.abduction = 7;
  gait.inward = 6;
  gait.finger_curl = 24;
  return choreograph(gait, 1);
}

}  // namespace mocapress::samples
