// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

class ErrorModel;

/// Points of the body whose errors count differently than in eps_x: they weigh more, or the decoder
/// moves them to their places.
struct PointResponse {
  std::vector<int> joints;  // joints whose origins are the points
  Eigen::MatrixXd places;   // original places: frames x 3 * points, cm, in world space
  std::vector<int> angles;  // channels that the decoder turns to move them; empty: none
  // The decoder's turns, in radians for each cm that a point has to move: frames x 3 * points *
  // angles.
  Eigen::MatrixXd turns;
  // Extra cost of each point's squared error, before the decoder moves it: frames x points.
  // Multiples of the squared cm of eps_x.
  Eigen::MatrixXd weights;
};

/// The change that a PointResponse makes to G_t of an ErrorModel. Let J be the movement of the
/// points by all channels and K the turns. An error e of the channels leaves (1 - K J) e, so that
///
///   G' = (1 - K J)^T G (1 - K J) + J^T W J = G - J^T B - B^T J + J^T C J,
///   B = K^T G,   C = B K + W.
///
/// The change has rank 6 for each point, 3 if nothing turns. It is zero except for channels that
/// move the points and channels that share landmarks with them.
class PointTerm {
 public:
  PointTerm(const ErrorModel& model, const PointResponse& response);

  /// Adds the change's diagonal, frames x channels.
  void add_curvature(Eigen::MatrixXd& curvature) const;

  /// The term's part of the gradient in two steps: errors become forces, for an error of `delta`
  /// (one value a frame) in `channel` or for all, and forces become work on a channel.
  Eigen::MatrixXf no_forces() const { return Eigen::MatrixXf::Zero(forces_.rows(), width_); }
  Eigen::MatrixXf forces_of(const Eigen::MatrixXf& errors) const;  // frames x channels
  void add_forces(int channel, const Eigen::Ref<const Eigen::ArrayXf>& delta,
                  Eigen::MatrixXf& forces) const;
  void add_work(int channel, const Eigen::MatrixXf& forces,
                Eigen::Ref<Eigen::ArrayXf> gradient) const;

  /// Adds the change for each pair of some channels to their rows and columns of `sums`. It is
  /// summed over frames from `first` on that are `apart` frames apart, each times its weight.
  void add_sums(const std::vector<int>& channels, Eigen::Index first, Eigen::Index apart,
                const Eigen::ArrayXf& weights, Eigen::MatrixXf& sums) const;

  /// Does both steps at once: adds the change times an error of `delta` in `channel` alone.
  void add_to_gradient(int channel, const Eigen::VectorXd& delta, Eigen::MatrixXd& gradient) const;

 private:
  Eigen::Index place_of(int channel) const { return place_[static_cast<std::size_t>(channel)]; }

  std::vector<int> channels_;  // channels for which the change is not zero
  std::vector<int> place_;     // each channel's place among them, or -1
  Eigen::Index width_ = 0;     // numbers for each channel and frame
  // motions_: J and B, or J alone if nothing turns. forces_: C J - B and -J. Both: frames x width *
  // channels_.
  Eigen::MatrixXf motions_;
  Eigen::MatrixXf forces_;
};

}  // namespace mocapress
