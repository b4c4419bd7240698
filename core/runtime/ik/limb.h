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
  std::int16_t parent;  // number of the parent's link; -1: the joint's parent is not a link
};

/// An angle that the solver may change.
struct LimbTurn {
  std::uint16_t channel;
  std::uint16_t link;
  std::uint8_t axis;   // 0 1 2: x y z
  std::uint8_t moves;  // one bit per effector: set if the angle moves it
};

/// A limb: effectors whose chains share joints, with all joints between them and the root.
struct LimbPlan {
  int effectors = 0;
  int links = 0;
  int turns = 0;
  bool is_two_bones = false;  // true: the limb has one effector and two bones. Angles 0 to 2 are
                              // those of a ball joint, angle 3 that of a hinge below
  const std::uint16_t* effector_numbers = nullptr;  // for each effector: its number among the
                                                    // effectors of all limbs
  const std::uint16_t* effector_links = nullptr;
  const LimbLink* link = nullptr;  // parents first
  const LimbTurn* turn = nullptr;  // ordered by link and channel
};

/// The most coordinates that the effectors of a limb have.
inline constexpr int kMostRows = 3 * kMostEffectorsOfLimb;

/// Forward kinematics of a limb, for the solver. The solver changes the angles: the rotation
/// channels of the joints in the effectors' chains. All other channels keep their values in the
/// frame.
class Limb {
 public:
  Limb(Memory& memory, int most_links);

  /// Sets the limb and its skeleton. The arrays must exist as long as this object uses them.
  void set(const LimbPlan& plan, const JointModel* joints) {
    plan_ = plan;
    joints_ = joints;
  }
  const LimbPlan& plan() const { return plan_; }

  /// Loads the channels of a frame. `frame` must exist as long as this object uses it.
  template <typename Real>
  void set_frame(const Real* frame);

  double angle(int angle) const { return angles_[angle]; }

  /// Adds `by` to one angle, or to all angles, in radians.
  void turn(int angle, double by);
  void turn(const double* by);

  /// Position of an effector in world space, in cm, with the current angles.
  const Vector3& position(int effector) const {
    return places_[plan_.effector_links[effector]].origin;
  }

  /// Velocity of an effector in cm per radian of `angle`; zero if the angle does not move it.
  Vector3 velocity(int effector, int angle) const;

  /// Turns the ball joint of a two-bone limb by a rotation in world space.
  void turn_ball(const Matrix3& rotation);

  /// Mean squared motion of the limb's joints per unit of `angle`, in cm^2 per radian^2.
  double disturbance(int angle) const;

  /// Work space for the solver: the velocities of all effectors, as kMostRows rows of kMostAngles
  /// numbers. The caller provides it, because it is too large for the stack.
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
