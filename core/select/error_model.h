// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {

/// What one unit more of each signal does to a joint, at the original pose.
struct SignalMoves {
  struct Place {
    int joint;
    bool rotates;  // about the joint's origin; else translates
  };
  std::vector<Place> places;
  // frames x 3 * signals: axis and size of the small rotation (radians), or translation (cm), in
  // the world
  Eigen::MatrixXd axes;
};

/// eps_x as a quadratic form. Near the original pose of frame t a landmark moves by J_t e, with e
/// the error of the channels, so that
///
///   eps_x^2 ~ (1/n) sum_t e_t^T G_t e_t,   G_t = J_t^T W J_t.
///
/// No matrix is formed: a channel's error is carried outward to the landmarks of its subtree as a
/// displacement, weighted to a force, and the forces and their moments are summed inward, as in
/// the recursive dynamics of linkages. Immutable, shared by any number of states.
class ErrorModel {
 public:
  ErrorModel(const Skeleton& skeleton, const Clip& original, Weighting weighting);
  ErrorModel(const Skeleton& skeleton, const Clip& original, const Eigen::VectorXd& weights);

  /// The same for signals other than the skeleton's channels, which stand for "channels" below.
  ErrorModel(const Skeleton& skeleton, const Clip& original, const Eigen::VectorXd& weights,
             SignalMoves moves);

  int frames() const { return static_cast<int>(axes_.rows()); }
  int channels() const { return static_cast<int>(curvature_.cols()); }

  /// D: the diagonal of G_t, frames x channels. (cm per unit of the channel)^2.
  const Eigen::MatrixXd& curvature() const { return curvature_; }

  /// gradient += G times an error of `delta` (one value a frame) in `channel` alone.
  /// Touches only the channels that share landmarks with it.
  void add_to_gradient(int channel, const Eigen::VectorXd& delta, Eigen::MatrixXd& gradient) const;

 private:
  void compute_curvature();

  std::vector<int> parents_;
  std::vector<std::vector<int>> subtrees_;  // joints, parents first, for each joint
  std::vector<std::vector<int>> joint_channels_;
  std::vector<std::vector<int>> joint_landmarks_;  // with weight > 0
  std::vector<SignalMoves::Place> places_;
  Eigen::VectorXd weights_;  // of the landmarks
  Eigen::MatrixXd tracks_;   // landmark_tracks(): frames x 3 * landmarks, cm
  Eigen::MatrixXd axes_;     // frames x 3 * channels: as SignalMoves has them
  Eigen::MatrixXd curvature_;
};

/// The error of a set of channels so far, and what it costs.
class ErrorState {
 public:
  /// No error in any channel.
  explicit ErrorState(const ErrorModel& model);

  /// Adds `delta` (one value a frame) to the error of `channel`.
  void add(int channel, const Eigen::VectorXd& delta);

  /// What add() would do to squared_eps(). O(frames).
  double change(int channel, const Eigen::VectorXd& delta) const;

  double squared_eps() const { return squared_eps_; }            // cm^2
  const Eigen::MatrixXd& gradient() const { return gradient_; }  // G e: frames x channels

 private:
  const ErrorModel* model_;
  Eigen::MatrixXd gradient_;
  double squared_eps_ = 0;
};

}  // namespace mocapress
