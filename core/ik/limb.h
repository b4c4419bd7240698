// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/ik/effector.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {

/// Effectors that share joints, and the joints between them and the root: forward kinematics of no
/// more than a solver needs. `angles` are the rotation channels of the effectors' chains, which may
/// change; all others keep the values of the frame. No allocation after construction.
class Limb {
 public:
  Limb(const Skeleton& skeleton, std::vector<Effector> effectors);

  const std::vector<Effector>& effectors() const { return effectors_; }
  int angle_count() const { return static_cast<int>(angles_.size()); }

  /// The column of a clip that holds this angle.
  int channel(int angle) const { return turns_[static_cast<std::size_t>(angle)].channel; }

  /// Takes a frame's values as they are.
  void set_frame(const FrameRow& frame);

  const Eigen::VectorXd& angles() const { return angles_; }

  /// Adds to one angle, or to all of them. radians
  void turn(int angle, double by);
  void turn(const Eigen::Ref<const Eigen::VectorXd>& by);

  /// Where the effector is with the present angles. cm, in the world.
  const Eigen::Vector3d& position(int effector) const;

  /// What a small turn of `angle` would do to the effector: cm a radian, zero where it does not
  /// move it.
  Eigen::Vector3d velocity(int effector, int angle) const;

  /// Whether angles 0 to 2 are those of a ball joint and angle 3 that of a hinge below it, and
  /// there is one effector: what can be solved at once.
  bool is_two_bones() const { return is_two_bones_; }

  /// Turns the ball joint of two bones by a rotation in the world.
  void turn_ball(const Eigen::Matrix3d& rotation);

  /// How much a turn of `angle` moves the limb: the mean over its joints of cm^2 / radian^2.
  double disturbance(int angle) const;

  /// Axis (unit, in the world) and centre of an angle's turn.
  const Eigen::Vector3d& axis(int angle) const {
    return turns_[static_cast<std::size_t>(angle)].axis_in_world;
  }
  const Eigen::Vector3d& center(int angle) const;
  bool moves(int angle, int effector) const;

 private:
  /// One joint between the root and an effector.
  struct Link {
    const Joint* joint;
    int joint_index;
    int parent;  // link, -1: the root's parent
    int first_channel;
    Eigen::Vector3d origin_in_world = Eigen::Vector3d::Zero();
    Eigen::Matrix3d world_from_joint = Eigen::Matrix3d::Identity();
  };
  /// One angle that may change.
  struct Turn {
    int channel;
    int link;
    int axis;  // 0 1 2: x y z
    Eigen::Vector3d axis_in_world = Eigen::Vector3d::Zero();
  };

  int link_of(int joint) const;
  bool find_two_bones() const;
  void update(int first_link);

  std::vector<Effector> effectors_;
  std::vector<int> effector_links_;
  std::vector<Link> links_;     // parents first
  std::vector<Turn> turns_;     // in the order of links and channels
  int first_turning_link_ = 0;  // those before it stay where the frame has them
  bool is_two_bones_ = false;
  std::vector<bool> moves_;           // effectors x turns
  std::vector<int> turn_of_channel_;  // -1: keeps the frame's value
  Eigen::RowVectorXd frame_;
  Eigen::VectorXd angles_;
};

/// Groups effectors whose chains share joints, so that each limb can be solved by itself.
std::vector<Limb> limbs_of(const Skeleton& skeleton, const std::vector<Effector>& effectors);

/// What a solver has room for, of one limb.
inline constexpr int kMostEffectors = 8;
inline constexpr int kMostAngles = 64;

/// Throws Error when a limb of these effectors has more than that, or a joint stands twice.
void check_effectors(const Skeleton& skeleton, const std::vector<Effector>& effectors);

}  // namespace mocapress
