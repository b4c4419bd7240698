// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {

/// World positions (cm) of a body over a clip: those of landmark_tracks(), then those of
/// shell_points(). Frames x 3 * (landmarks + 3 * joints). The position of any point that is fixed
/// to a joint is an affine combination of that joint's origin and its shell points.
Eigen::MatrixXd body_tracks(const Skeleton& skeleton, const Clip& clip);

/// Errors of each joint's position and rotation: differences of body_tracks(), joint by joint.
class JointErrors {
 public:
  /// Frames x 12: the error of the origin (cm), then that of each axis (cm for each cm along it).
  using OfJoint = Eigen::Matrix<double, Eigen::Dynamic, 12>;

  /// Takes rows of body_tracks() of both clips, which must outlive this. Few rows at a time keep
  /// the results in the cache.
  JointErrors(const Skeleton& skeleton, const Eigen::Ref<const Eigen::MatrixXd>& original,
              const Eigen::Ref<const Eigen::MatrixXd>& decoded);

  /// Errors of a joint, computed when first asked for.
  const OfJoint& of(int joint);

  /// The squared error of a point at each frame, cm^2.
  static void find_squares(const OfJoint& of_joint, const Eigen::Vector3d& in_joint,
                           Eigen::Ref<Eigen::VectorXd> squares);

  /// The angle by which the joint is turned, at each frame.
  static Eigen::VectorXd degrees(const OfJoint& of_joint);

 private:
  Eigen::Ref<const Eigen::MatrixXd> original_;
  Eigen::Ref<const Eigen::MatrixXd> decoded_;
  Eigen::Index shell_;  // column of the first shell point
  std::vector<std::optional<OfJoint>> found_;
};

/// Some frames of body_tracks(), not copied.
using TrackRows = Eigen::Ref<const Eigen::MatrixXd>;

/// Receives body_tracks() of the frames from `first_frame` on.
using TrackBlock = std::function<void(int first_frame, const Eigen::MatrixXd& tracks)>;

/// Visits body_tracks() of a clip in order of time, some frames at a time, so that its tracks are
/// never all in memory.
void visit_tracks(const Skeleton& skeleton, const Clip& clip, const TrackBlock& visit);

}  // namespace mocapress
