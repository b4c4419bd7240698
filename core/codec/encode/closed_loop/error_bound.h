// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/codec/encode/closed_loop/bound_kernels.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// A bound on the error of every point of a weighting and every joint's origin, checked while one
/// channel after another changes. It is exact: everything below a joint turns about it as one
/// piece.
class ErrorBound {
 public:
  /// A bound for each frame.
  /// The motion must outlive this.
  ErrorBound(const Motion& original, Weighting weighting, const Eigen::VectorXd& bound_cm);

  /// Begins a pass over the channels of this clip.
  void begin(const Clip& decoded);

  /// The largest distance over its bound.
  double furthest() const;

  /// Goes on to the next channel, 0 first.
  void next();

  /// Whether `delta`, added to that channel from a frame on, takes no landmark beyond the bound,
  /// and none that is already beyond it further away.
  bool allows(Eigen::Index first_frame, const Eigen::VectorXd& delta);
  void add(Eigen::Index first_frame, const Eigen::VectorXd& delta);

 private:
  using Rotations = std::vector<Eigen::Matrix3d>;  // one a frame

  /// A landmark that the channel moves, by sin(delta) * along + (1 - cos(delta)) * across, or by
  /// delta * along where it translates. Both frames x 3, cm.
  struct Moved {
    Eigen::Index landmark = 0;
    Eigen::MatrixX3d along;
    Eigen::MatrixX3d across;
  };

  /// What `delta` does, as factors of both. None of across where the channel translates.
  struct Step {
    Eigen::ArrayXd along;
    Eigen::ArrayXd across;

    MovingSteps of_frames() const { return {along.data(), across.data(), along.size()}; }
  };

  void enter_joint(int joint);
  void find_moved();
  bool is_at_or_below(int joint, int other) const;
  Step step_of(const Eigen::VectorXd& delta) const;

  /// From that frame on.
  MovedFrames frames_of(Moved& moved, Eigen::Index first_frame);

  const Skeleton& skeleton_;
  const Eigen::ArrayXd squared_bound_;     // of each frame
  const std::vector<Landmark> points_;     // joints' origins first
  const Eigen::MatrixXd original_tracks_;  // of them
  Eigen::MatrixXd channels_;               // frames x channels
  Eigen::MatrixXd errors_;                 // frames x 3 * landmarks, cm
  Eigen::MatrixXd squared_;                // of them: frames x landmarks
  int channel_ = -1;
  int joint_ = -1;                           // of the channel
  std::vector<Rotations> world_from_joint_;  // of the joints before that
  Rotations world_from_axes_;                // before the channel's own turn
  std::vector<Moved> moved_;                 // as many as there are landmarks, to keep their memory
  std::size_t moved_count_ = 0;
};

}  // namespace mocapress
