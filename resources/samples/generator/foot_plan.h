// SPDX-License-Identifier: MIT
// Based on: Perry & Burnfield, "Gait Analysis", 2nd ed. 2010, chapter 3: in stance the foot rolls
// over heel, ankle, forefoot and toe "rockers".
#pragma once

#include <Eigen/Core>
#include <vector>

#include "resources/samples/generator/curves.h"

namespace mocapress::samples {

/// Where a foot is. It turns about y by `yaw`, then about its own x by `pitch` (heel up).
struct FootState {
  Eigen::Vector3d ankle;  // cm, in the world
  double yaw;             // radians
  double pitch;           // radians; the toes' own is `toe_pitch`, both against the floor
  double toe_pitch;

  Eigen::Matrix3d world_from_foot() const;
  Eigen::Matrix3d world_from_toes() const;
  Eigen::Vector3d heel() const;  // soles, cm in the world
  Eigen::Vector3d ball() const;
  Eigen::Vector3d tip() const;
};

/// One contact with the floor: down on heel or ball, flat, up over the ball, then over the toe tip.
struct Stance {
  double touchdown;          // s
  double liftoff;            // s
  Eigen::Vector3d print;     // cm, on the floor below the ankle of the flat foot
  double yaw;                // radians
  double touchdown_pitch;    // radians; below 0 the heel is first, above 0 the ball
  double liftoff_pitch;      // radians
  double liftoff_toe_pitch;  // radians
  double settling;           // s, from touchdown to flat
  double heel_rise;          // s, from heel off to liftoff
  double toe_rise;           // s, from toes off to liftoff

  FootState at(double seconds) const;
  bool heel_down(double seconds) const;
  bool ball_down(double seconds) const;
};

/// A foot's state at an instant of its swing.
struct Waypoint {
  double seconds;
  FootState foot;
};

/// All contacts of one foot, joined by swings that leave and land without a jump in velocity.
class FootPlan {
 public:
  /// swings[i] leads from stances[i] to stances[i + 1].
  FootPlan(std::vector<Stance> stances, const std::vector<std::vector<Waypoint>>& swings);

  /// The first stance holds before it, the last after it.
  FootState at(double seconds) const;
  /// The contact at that time, or nullptr in a swing.
  const Stance* stance_at(double seconds) const;
  const std::vector<Stance>& stances() const { return stances_; }

 private:
  std::vector<Stance> stances_;
  std::vector<ClampedSpline> swings_;
};

}  // namespace mocapress::samples
