// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

#include "core/motion/landmarks.h"

namespace mocapress {

/// Where a body is over a clip: the world positions (cm) of landmark_tracks(), then of
/// shell_points(). Frames x 3 * (landmarks + 3 * joints). The position of any point that is fixed
/// to a joint is an affine combination of that joint's origin and its shell points.
Eigen::MatrixXd body_tracks(const Skeleton& skeleton, const Clip& clip);

/// How far each joint is from where it was and how far it is turned: differences of body_tracks(),
/// joint by joint.
class JointErrors {
 public:
  /// Rows of body_tracks() of both clips; they must outlive this.
  JointErrors(const Skeleton& skeleton, const Eigen::Ref<const Eigen::MatrixXd>& original,
              const Eigen::Ref<const Eigen::MatrixXd>& decoded);

  /// Frames x 12: the error of the origin (cm), then of each axis (per cm along it).
  Eigen::Matrix<double, Eigen::Dynamic, 12> of(int joint) const;

  /// Of a point: cm^2 at each frame.
  static Eigen::VectorXd squared(const Eigen::Matrix<double, Eigen::Dynamic, 12>& of_joint,
                                 const Eigen::Vector3d& in_joint);

  /// By how much the joint is turned at each frame.
  static Eigen::VectorXd degrees(const Eigen::Matrix<double, Eigen::Dynamic, 12>& of_joint);

 private:
  Eigen::Ref<const Eigen::MatrixXd> original_;
  Eigen::Ref<const Eigen::MatrixXd> decoded_;
  Eigen::Index shell_;  // column of the first shell point
};

/// Some frames of body_tracks(), where they stand.
using TrackRows = Eigen::Ref<const Eigen::MatrixXd>;

/// body_tracks() of some frames: those of `first_frame` and after.
using TrackBlock = std::function<void(int first_frame, const Eigen::MatrixXd& tracks)>;

/// Visits body_tracks() of a clip in time: all at once or, of a long clip, some thousand frames
/// at a time, so that they are never all in memory.
void visit_tracks(const Skeleton& skeleton, const Clip& clip, const TrackBlock& visit);

}  // namespace mocapress
