// SPDX-License-Identifier: MIT
// Based on: Perry & Burnfield, "Gait Analysis", 2nd ed. 2010 (order of events, ranges of joints);
// Novacheck, "The biomechanics of running", Gait & Posture 7, 1998 (the same for running).
#pragma once

#include <cstdint>
#include <vector>

#include "resources/samples/generator/performer.h"

namespace mocapress::samples {

/// A way of walking or running along an arc. Angles in degrees, lengths in cm, times in s.
struct Gait {
  double seconds;

  double speed;  // cm/s, between starting and stopping
  double start;  // when the body sets off, from rest
  double start_duration;
  double stop;  // when it begins to stop
  double stop_duration;
  double curvature;   // 1/cm, above 0 to the left
  double arc_middle;  // distance gone where it heads straight along z

  double first_liftoff;  // the right foot's; then the sides take turns
  double step_duration;
  double swing_duration;
  int steps;
  double print_behind;  // distance of the ankle behind the body in the middle of its stance
  double half_step_width;
  double half_standing_width;
  double toe_out;
  double touchdown_pitch;  // below 0: heel first
  double liftoff_pitch;
  double liftoff_toe_pitch;
  double settling;  // this and the next two as in Stance
  double heel_rise;
  double toe_rise;

  /// An instant of the swing in a full stride; shorter strides lift the foot less.
  struct SwingPoint {
    double share;   // share of the swing's duration
    double way;     // share of the way that the ankle goes, seen from the body
    double height;  // the ankle's, above where it stands
    double pitch;
    double toe_pitch;
  };
  std::vector<SwingPoint> swing;
  double swing_out;  // sideways, of the foot in mid-air

  Centre centre_of;
  double centre_height;
  double sway;         // share of the way to the loaded foot that the body goes sideways
  double lean;         // the trunk's
  double pelvis_turn;  // with a foot ahead
  double pelvis_drop;  // on the unloaded side
  double chest_turn;   // against the pelvis
  double arm_swing;
  double elbow;
  double elbow_swing;
  double abduction;
  double inward;  // turn of the upper arm when it comes ahead
  double finger_curl;
};

/// The same seed, the same steps. Motion is planned for a second and a half beyond the clip.
Choreography choreograph(const Gait& gait, std::uint64_t seed);

}  // namespace mocapress::samples
