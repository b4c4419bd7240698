// SPDX-License-Identifier: MIT
// Based on: Bobbert & van Ingen Schenau, "Coordination in vertical jumping", J. Biomechanics 21(3),
// 1988: countermovement, extension from the trunk to the feet, take-off near full extension.
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "resources/samples/generator/curves.h"
#include "resources/samples/generator/leg_ik.h"
#include "resources/samples/generator/samples.h"
#include "resources/samples/generator/signal.h"
#include "resources/samples/generator/variation.h"

namespace mocapress::samples {
namespace {

constexpr double kSeconds = 6;
constexpr double kStandingCentre = 97.5;  // cm above the floor
constexpr double kCentreBeforeAnkle = 5;  // cm, standing
constexpr double kHalfWidth = 11;         // cm, between the feet

/// One jump; heights (cm) are of the centre of mass against standing.
struct Leap {
  double start;  // s
  double from;   // cm along z, of the prints
  double to;
  double depth;          // distance that the countermovement goes down
  double takeoff_speed;  // cm/s, upwards
  double give;           // distance that the body sinks when it lands

  static constexpr double kTakeoffRise = 11;
  static constexpr double kTouchdownRise = -5;

  double bottom() const { return start + 0.58; }
  double takeoff() const { return bottom() + 0.29; }
  double touchdown() const { return takeoff() + flight(); }
  double low() const { return touchdown() + 0.22; }
  double upright() const { return low() + 0.70; }

  /// s, from take-off to touchdown
  double flight() const {
    const double fall = kTakeoffRise - kTouchdownRise;
    return (takeoff_speed + std::sqrt(takeoff_speed * takeoff_speed + 2 * kGravity * fall)) /
           kGravity;
  }
  /// cm, in flight
  double rise(double seconds) const {
    const double flown = seconds - takeoff();
    return kTakeoffRise + takeoff_speed * flown - kGravity / 2 * flown * flown;
  }
};

constexpr std::array<Leap, 2> kLeaps = {{
    {0.50, 0, 74, 27, 225, 23},
    {3.05, 74, 78, 31, 262, 26},
}};

BallisticTrack centre_track() {
  const auto at = [](double rise, double along) {
    return Eigen::Vector3d(0, kStandingCentre + rise, along + kCentreBeforeAnkle);
  };
  const Eigen::Vector3d rest = Eigen::Vector3d::Zero();
  const Eigen::Vector3d fall(0, -kGravity, 0);
  std::vector<BallisticTrack::Knot> knots;
  for (const Leap& leap : kLeaps) {
    const double way = leap.to - leap.from;
    const double ahead = 0.2 * way;  // gone at take-off; as much is left at touchdown
    const double speed = 0.65 * way / leap.flight();
    const Eigen::Vector3d takeoff(0, leap.takeoff_speed, speed);
    const Eigen::Vector3d touchdown = takeoff + leap.flight() * fall;
    knots.push_back({leap.start, at(0, leap.from), rest, rest});
    knots.push_back({leap.bottom(),
                     at(-leap.depth, leap.from + 0.25 * ahead),
                     {0, 0, 0.25 * speed},
                     {0, 700, speed}});
    knots.push_back({leap.takeoff(), at(Leap::kTakeoffRise, leap.from + ahead), takeoff, fall});
    knots.push_back({leap.touchdown(), at(Leap::kTouchdownRise, leap.from + ahead + 0.65 * way),
                     touchdown, fall});
    knots.push_back({leap.low(), at(-leap.give, leap.to + 1), {0, 0, 8}, {0, 500, -60}});
    knots.push_back({leap.upright(), at(0, leap.to), rest, rest});
  }
  return BallisticTrack(std::move(knots));
}

Stance stance_of(Side side, double along, Random& random) {
  const double sign = side == Side::Left ? 1 : -1;
  const auto varied = [&](double degrees) { return in_radians(degrees + 2 * jitter(random)); };
  Stance stance{};
  stance.touchdown_pitch = varied(24);
  stance.liftoff_pitch = varied(64);
  stance.liftoff_toe_pitch = varied(24);
  stance.yaw = sign * varied(9);
  stance.settling = 0.075;
  stance.heel_rise = 0.19;
  stance.toe_rise = 0.04;
  const double across = sign * kHalfWidth + jitter(random);
  stance.print = {across, 0, along + 1.5 * jitter(random)};
  return stance;
}

/// The legs go with the body, a little drawn up.
std::vector<Waypoint> swing(const Leap& leap, const Stance& from, const Stance& to) {
  struct Tuck {
    double share;  // share of the flight
    double ankle;  // cm, higher than under a standing body
    double pitch;  // degrees
  };
  std::vector<Waypoint> waypoints;
  for (const Tuck& tuck : {Tuck{0.25, 4, 66}, Tuck{0.55, 14, 48}, Tuck{0.85, 12, 28}}) {
    const double seconds = std::lerp(from.liftoff, to.touchdown, tuck.share);
    Eigen::Vector3d ankle = from.print + tuck.share * (to.print - from.print);
    ankle.y() = kAnkleHeight + leap.rise(seconds) + tuck.ankle;
    const double pitch = in_radians(tuck.pitch);
    waypoints.push_back(
        {seconds, {ankle, std::lerp(from.yaw, to.yaw, tuck.share), pitch, 0.8 * pitch}});
  }
  return waypoints;
}

FootPlan foot_plan(Side side, Random& random) {
  constexpr double kApart = 0.008;  // s, at most, between the feet
  std::vector<Stance> stances = {stance_of(side, kLeaps.front().from, random)};
  stances.front().touchdown = -1;
  std::vector<std::vector<Waypoint>> swings;
  for (const Leap& leap : kLeaps) {
    Stance& before = stances.back();
    before.liftoff = leap.takeoff() - kApart * random.unit();
    Stance after = stance_of(side, leap.to, random);
    after.touchdown = leap.touchdown() + kApart * random.unit();
    swings.push_back(swing(leap, before, after));
    stances.push_back(after);
  }
  stances.back().liftoff = kSeconds + 1;
  return FootPlan(std::move(stances), swings);
}

/// An angle at the moments of a leap, in degrees; at rest before the first and after the last.
struct Course {
  double rest;
  double bottom;
  double takeoff;
  double apex;
  double touchdown;
  double low;
  double overshoot;  // half-way back to rest

  Signal signal() const {
    std::vector<KeyTrack::Key> keys;
    for (const Leap& leap : kLeaps) {
      const double apex_time = leap.takeoff() + leap.takeoff_speed / kGravity;
      keys.insert(keys.end(), {{leap.start, rest},
                               {leap.bottom() - 0.03, bottom},
                               {leap.takeoff(), takeoff},
                               {apex_time, apex},
                               {leap.touchdown(), touchdown},
                               {leap.low() + 0.03, low},
                               {std::midpoint(leap.low(), leap.upright()), overshoot},
                               {leap.upright() + 0.10, rest}});
    }
    const KeyTrack track(std::move(keys));
    return Signal(-1, kSeconds + 1, [&](double t) { return track.at(t); }).smoothed(0.13);
  }
};

class JumpBody {
 public:
  explicit JumpBody(Random& random) : left_timing_(random), right_timing_(random) {}

  Eigen::Vector3d centre(double seconds) const { return centre_.at(seconds); }

  Posture posture(double seconds) const {
    const double bend = bend_.at(seconds);
    const double late = bend_.at(seconds - 0.04);
    Posture posture;
    auto& degrees = posture.degrees;
    degrees["root"] = {2 + 0.52 * bend, 0, 0};
    degrees["lowerback"] = {1 + 0.20 * bend, 0, 0};
    degrees["upperback"] = {1 + 0.16 * late, 0, 0};
    degrees["thorax"] = {0.12 * late, 0, 0};
    degrees["lowerneck"] = {6 - 0.10 * late, 0, 0};
    degrees["upperneck"] = {-4 - 0.35 * late, 0, 0};
    degrees["head"] = {-3 - 0.40 * bend_.at(seconds - 0.06), 0, 0};
    add_arm(posture, Side::Left, seconds, left_timing_);
    add_arm(posture, Side::Right, seconds - 0.012, right_timing_);
    return posture;
  }

 private:
  void add_arm(Posture& posture, Side side, double seconds, const Drift& timing) const {
    const double t = seconds + 0.008 * timing.at(seconds);
    const double swing = arm_.at(t);
    const double raised = std::max(0.0, -swing) / 120;
    posture.set(side, "clavicle", {0, -1 + 0.04 * swing, 1.5 + 9 * raised});
    posture.set(side, "humerus", {swing, -5 + 3 * raised, 9 - 15 * raised});
    posture.set(side, "radius", {-elbow_.at(t - 0.03), 0, 0});
    posture.set(side, "wrist", {0, -30 + 0.08 * arm_.at(t - 0.06), 0});
    posture.set(side, "hand", {8 + 0.06 * arm_.at(t - 0.07), 0, -3 + 0.05 * arm_.at(t - 0.05)});
    posture.set(side, "fingers", {26 + 0.10 * arm_.at(t - 0.08), 0, 0});
    posture.set(side, "thumb", {13 + 0.04 * arm_.at(t - 0.08), 0, 14 + 0.04 * arm_.at(t - 0.06)});
  }

  // Forward bending of pelvis and trunk together; upper arm, ahead below 0; elbow.
  Signal bend_ = Course{0, 48, -6, 2, 12, 42, 14}.signal();
  Signal arm_ = Course{0, 52, -118, -128, -70, -30, 14}.signal();
  Signal elbow_ = Course{20, 14, 52, 46, 40, 38, 18}.signal();
  BallisticTrack centre_ = centre_track();
  Drift left_timing_;
  Drift right_timing_;
};

}  // namespace

Choreography jump() {
  Random random(3);
  FootPlan left = foot_plan(Side::Left, random);
  FootPlan right = foot_plan(Side::Right, random);
  const auto body = std::make_shared<const JumpBody>(random);
  return {kSeconds,
          std::move(left),
          std::move(right),
          Centre::Mass,
          [body](double seconds) { return body->centre(seconds); },
          [body](double seconds) { return body->posture(seconds); }};
}

}  // namespace mocapress::samples
