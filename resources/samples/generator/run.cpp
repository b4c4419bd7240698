// SPDX-License-Identifier: MIT
#include "resources/samples/generator/gait.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::samples {

Choreography run() {
  Gait gait{};
  gait.seconds = 4.5;
  gait.speed = 275;
  gait.start = -12;  // long before the clip begins: the run is steady in all of it
  gait.start_duration = 1;
  gait.stop = 20;
  gait.stop_duration = 1;
  gait.curvature = 0.0005;
  gait.arc_middle = 275 * (11.5 + 2.25);
  gait.first_liftoff = -2.5;
  gait.step_duration = 0.34;
  gait.swing_duration = 0.435;
  gait.steps = 27;
  gait.print_behind = 18;
  gait.half_step_width = 3;
  gait.half_standing_width = 3;
  gait.toe_out = 5;
  gait.touchdown_pitch = -8;
  gait.liftoff_pitch = 66;
  gait.liftoff_toe_pitch = 30;
  gait.settling = 0.05;
  gait.heel_rise = 0.15;
  gait.toe_rise = 0.05;
  gait.swing = {{0.30, 0.135, 36, 90, 76}, {0.58, 0.80, 31, 50, 40}, {0.82, 1.16, 15, 4, -6}};
  gait.swing_out = 4;
  gait.centre_of = Centre::Mass;
  gait.centre_height = 97.3;
  gait.sway = 0.3;
  gait.lean = 13;
  gait.pelvis_turn = 4;
  gait.pelvis_drop = 4;
  gait.chest_turn = 11;
  gait.arm_swing = 26;
  gait.elbow = 88;
  gait.elbow_swing = 9;
  gait.abduction = 13;
  gait.inward = 14;
  gait.finger_curl = 55;
  return choreograph(gait, 2);
}

}  // namespace mocapress::samples
