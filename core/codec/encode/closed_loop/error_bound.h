// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/codec/encode/closed_loop/bound_kernels.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// A bound on the error of every measured point and every joint's origin, checked while channels
/// change one after another. The check is exact: everything below a joint turns about it rigidly.
class ErrorBound {
 public:
  /// Takes one bound for each frame. The motion must outlive this object.
  ErrorBound(const Motion& original, Weighting weighting, const Eigen::VectorXd& bound_cm);

  /// Starts a pass over the channels of `decoded`.
  void begin(const Clip& decoded);

  /// The largest ratio of an error to its bound.
  double furthest() const;

  /// Moves to the next channel; the first call moves to channel 0.
  void next();

  /// Returns whether adding `delta` to the current channel from first_frame on keeps every landmark
  /// within its bound; a landmark already beyond its bound must not move further away.
  bool allows(Eigen::Index first_frame, const Eigen::VectorXd& delta);
  void add(Eigen::Index first_frame, const Eigen::VectorXd& delta);

 private:
  using Rotations = std::vector<Eigen::Matrix3d>;  // one a frame

  /// A landmark that the channel moves: by sin(delta) * along + (1 - cos(delta)) * across for a
  /// rotation, by delta * along for a translation. Both are frames x 3, in cm.
  struct Moved {
    Eigen::Index landmark = 0;
    Eigen::MatrixX3d along;
    Eigen::MatrixX3d across;
  };

  /// Factors of Moved::along and Moved::across, one pair a frame, by which a change moves a
  /// landmark. `across` is empty for a translation.
  struct Step {
    Eigen::ArrayXd along;
    Eigen::ArrayXd across;

    MovingSteps of_frames() const { return {along.data(), across.data(), along.size()}; }
  };

  void enter_joint(int joint);
  void find_moved();
  bool is_at_or_below(int joint, int other) const;
  Step step_of(const Eigen::VectorXd& delta) const;

  /// The frames of `moved` from `first_frame` on.
  MovedFrames frames_of(Moved& moved, Eigen::Index first_frame);

  const Skeleton& skeleton_;
  const Eigen::ArrayXd squared_bound_;     // one for each frame
  const std::vector<Landmark> points_;     // joints' origins first
  const Eigen::MatrixXd original_tracks_;  // tracks of points_
  Eigen::MatrixXd channels_;               // frames x channels
  Eigen::MatrixXd errors_;                 // frames x 3 * landmarks, cm
  Eigen::MatrixXd squared_;                // squared lengths of errors_: frames x landmarks
  int channel_ = -1;
  int joint_ = -1;                           // joint of the current channel
  std::vector<Rotations> world_from_joint_;  // one for each joint before joint_
  Rotations world_from_axes_;  // the joint's axes, turned by its channels before the current one
  std::vector<Moved> moved_;   // one for each landmark, kept to reuse their memory
  std::size_t moved_count_ = 0;
};

}  // namespace mocapress
