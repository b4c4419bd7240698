// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// One joint between the root and an effector.
struct LimbLink {
  std::uint16_t joint;
  std::int16_t parent;  // link, -1: the root's parent
};

/// One angle that may change.
struct LimbTurn {
  std::uint16_t channel;
  std::uint16_t link;
  std::uint8_t axis;   // 0 1 2: x y z
  std::uint8_t moves;  // a bit for each effector
};

/// Effectors that share joints, and the joints between them and the root.
struct LimbPlan {
  int effectors = 0;
  int links = 0;
  int turns = 0;
  bool is_two_bones = false;  // angles 0 to 2 are a ball joint's, 3 a hinge's below; one effector
  const std::uint16_t* effector_numbers = nullptr;  // among those of all limbs
  const std::uint16_t* effector_links = nullptr;
  const LimbLink* link = nullptr;  // parents first
  const LimbTurn* turn = nullptr;  // in the order of links and channels
};

/// Forward kinematics of no more than a solver needs. `angles` are the rotation channels of the
/// effectors' chains, which may change; all others keep the values of the frame.
class Limb {
 public:
  Limb(Memory& memory, int most_links);

  /// Which limb, of which joints. Both must outlive its use.
  void set(const LimbPlan& plan, const JointModel* joints) {
    plan_ = plan;
    joints_ = joints;
  }
  const LimbPlan& plan() const { return plan_; }

  /// Takes a frame's channels as they are. `frame` must outlive all further use.
  template <typename Real>
  void set_frame(const Real* frame);

  double angle(int angle) const { return angles_[angle]; }

  /// Adds to one angle, or to all of them. radians
  void turn(int angle, double by);
  void turn(const double* by);

  /// Where the effector is with the present angles. cm, in the world.
  const Vector3& position(int effector) const {
    return places_[plan_.effector_links[effector]].origin;
  }

  /// What a small turn of `angle` would do to the effector: cm a radian, zero where it does not
  /// move it.
  Vector3 velocity(int effector, int angle) const;

  /// Turns the ball joint of two bones by a rotation in the world.
  void turn_ball(const Matrix3& rotation);

  /// How much a turn of `angle` moves the limb: the mean over its joints of cm^2 / radian^2.
  double disturbance(int angle) const;

  /// Axis (unit, in the world) and centre of an angle's turn.
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
  JointPlace* places_;  // of links
  double* values_;      // of links: those of its channels, the angles as of the frame
  double angles_[kMostAngles] = {};
  Vector3 axes_[kMostAngles];
};

}  // namespace mocapress::runtime
