// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// A joint between the root and an effector.
struct LimbLink {
  std::uint16_t joint;
  std::int16_t parent;  // link number; -1: the root's parent
};

/// An angle that the solver may change.
struct LimbTurn {
  std::uint16_t channel;
  std::uint16_t link;
  std::uint8_t axis;   // 0 1 2: x y z
  std::uint8_t moves;  // the effectors that it moves, one bit each
};

/// Effectors that share joints, with all joints between them and the root.
struct LimbPlan {
  int effectors = 0;
  int links = 0;
  int turns = 0;
  bool is_two_bones = false;  // angles 0 to 2 are those of a ball joint, angle 3 that of a hinge
                              // below it; one effector
  const std::uint16_t* effector_numbers = nullptr;  // numbers among the effectors of all limbs
  const std::uint16_t* effector_links = nullptr;
  const LimbLink* link = nullptr;  // parents first
  const LimbTurn* turn = nullptr;  // ordered by link and channel
};

/// Coordinates of all effectors of a limb.
inline constexpr int kMostRows = 3 * kMostEffectorsOfLimb;

/// Forward kinematics of a limb, for the solver. `angles` are the rotation channels of the
/// effectors' chains, which may change; all other channels keep the values of the frame.
class Limb {
 public:
  Limb(Memory& memory, int most_links);

  /// Sets the limb and its skeleton. Both must outlive its use.
  void set(const LimbPlan& plan, const JointModel* joints) {
    plan_ = plan;
    joints_ = joints;
  }
  const LimbPlan& plan() const { return plan_; }

  /// Loads the channels of a frame. `frame` must outlive all further use.
  template <typename Real>
  void set_frame(const Real* frame);

  double angle(int angle) const { return angles_[angle]; }

  /// Adds to one angle, or to all angles. radians
  void turn(int angle, double by);
  void turn(const double* by);

  /// Position of an effector with the current angles. cm, in world space.
  const Vector3& position(int effector) const {
    return places_[plan_.effector_links[effector]].origin;
  }

  /// Velocity of an effector per unit of `angle`: cm per radian, zero if the angle does not move
  /// it.
  Vector3 velocity(int effector, int angle) const;

  /// Turns the ball joint of a two-bone limb by a rotation in world space.
  void turn_ball(const Matrix3& rotation);

  /// Mean squared motion of the limb's joints per unit of `angle`, in cm^2 per radian^2.
  double disturbance(int angle) const;

  /// Room for the velocities of all effectors: kMostRows rows of kMostAngles numbers, for the
  /// solver. It is the caller's memory, as it is large for a stack.
  double* velocities() { return velocities_; }

  /// Axis (unit vector) and centre of an angle's rotation, in world space.
  const Vector3& axis(int angle) const { return axes_[angle]; }
  const Vector3& center(int angle) const { return places_[plan_.turn[angle].link].origin; }
  bool moves(int angle, int effector) const {
    return (plan_.turn[angle].moves >> effector & 1) != 0;
  }

 private:
  void update(int first_link);
  int first_turning_link() const { return plan_.turns > 0 ? plan_.turn[0].link : 0; }

  LimbPlan plan_;
  const JointModel* joints_ = nullptr;
  JointPlace* places_;  // one per link
  double* values_;      // channels of the links, with the current angles
  double* velocities_;
  double angles_[kMostAngles] = {};
  Vector3 axes_[kMostAngles];
};

}  // namespace mocapress::runtime
