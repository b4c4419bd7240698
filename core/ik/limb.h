// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/ik/effector.h"
#include "core/motion/forward_kinematics.h"
#include "core/runtime/ik/limb.h"
#include "core/runtime/own_memory.h"

namespace mocapress {

/// The joints of a skeleton in the runtime's form, without their names.
std::vector<runtime::JointModel> models_of(const Skeleton& skeleton);

/// The runtime's limb (core/runtime/ik/limb.h) with memory of its own: effectors that share joints,
/// and the joints between them and the root. `angles` are the rotation channels of the effectors'
/// chains, which may change; all others keep the values of the frame.
class Limb {
 public:
  /// Throws Error if these effectors are not one limb that can be solved.
  Limb(const Skeleton& skeleton, const std::vector<Effector>& effectors);

  /// The effectors in the order of solving.
  const std::vector<Effector>& effectors() const { return effectors_; }
  int angle_count() const { return plan().turns; }

  /// The column of a clip that holds this angle.
  int channel(int angle) const { return plan().turn[angle].channel; }

  /// Sets all channels to the values of a frame.
  void set_frame(const FrameRow& frame);

  Eigen::VectorXd angles() const;

  /// Adds radians to one angle, or to all of them.
  void turn(int angle, double by) { (*limb_)->turn(angle, by); }
  void turn(const Eigen::VectorXd& by) { (*limb_)->turn(by.data()); }

  /// Position of the effector with the present angles (cm, world space).
  Eigen::Vector3d position(int effector) const { return vector((*limb_)->position(effector)); }

  /// The effector's velocity as `angle` turns, in cm a radian; zero if the angle does not move the
  /// effector.
  Eigen::Vector3d velocity(int effector, int angle) const {
    return vector((*limb_)->velocity(effector, angle));
  }

  /// True if the limb is a ball joint with a hinge below it and one effector. Such a limb is solved
  /// in closed form.
  bool is_two_bones() const { return plan().is_two_bones; }

  /// Centre of an angle's turn.
  Eigen::Vector3d center(int angle) const { return vector((*limb_)->center(angle)); }

  runtime::Limb& of_decoder() { return **limb_; }

 private:
  static Eigen::Vector3d vector(const runtime::Vector3& v) { return {v[0], v[1], v[2]}; }
  const runtime::LimbPlan& plan() const { return (*limb_)->plan(); }

  std::vector<Effector> effectors_;
  std::vector<runtime::JointModel> joints_;
  // Storage that the plan points to.
  std::vector<std::uint16_t> effector_numbers_;
  std::vector<std::uint16_t> effector_links_;
  std::vector<runtime::LimbLink> links_;
  std::vector<runtime::LimbTurn> turns_;
  std::unique_ptr<OwnMemory<runtime::Limb>> limb_;
  Eigen::RowVectorXd frame_;
};

/// Groups effectors whose chains share joints, so that each limb can be solved by itself.
std::vector<Limb> limbs_of(const Skeleton& skeleton, const std::vector<Effector>& effectors);

/// Throws Error if a limb of these effectors has more effectors or angles than a solver has room
/// for, if there are more than runtime::kMostEffectors, or if a joint occurs twice.
void check_effectors(const Skeleton& skeleton, const std::vector<Effector>& effectors);

}  // namespace mocapress
