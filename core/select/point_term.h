// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mocapress {

class ErrorModel;

/// Points of the body whose errors count otherwise than eps_x has it: because they weigh more, or
/// because the decoder will put them where they belong.
struct PointResponse {
  std::vector<int> joints;  // whose origins the points are
  Eigen::MatrixXd places;   // where the original has them: frames x 3 * points, cm, in the world
  std::vector<int> angles;  // the channels that the decoder turns to move them; none: it does not
  // What it turns them by, radians a cm that a point is to move: frames x 3 * points * angles.
  Eigen::MatrixXd turns;
  // What a squared error of each point costs beside that, before the decoder moves it: frames x
  // points. Multiples of the squared cm of eps_x.
  Eigen::MatrixXd weights;
};

/// What that adds to G_t of an ErrorModel. With J the movement of the points by all channels and K
/// the turns, an error e of the channels leaves (1 - K J) e behind, so that
///
///   G' = (1 - K J)^T G (1 - K J) + J^T W J = G - J^T B - B^T J + J^T C J,
///   B = K^T G,   C = B K + W.
///
/// Of rank 6 a point, 3 where nothing turns, and zero but for the channels that move the points and
/// what is moved with them.
class PointTerm {
 public:
  PointTerm(const ErrorModel& model, const PointResponse& response);

  /// Adds its diagonal, frames x channels.
  void add_curvature(Eigen::MatrixXd& curvature) const;

  /// What it makes of errors, of which it then makes its part of the gradient: first of an error of
  /// `delta` (one value a frame) in `channel`, then there.
  Eigen::MatrixXf no_forces() const { return Eigen::MatrixXf::Zero(forces_.rows(), width_); }
  Eigen::MatrixXf forces_of(const Eigen::MatrixXf& errors) const;  // frames x channels
  void add_forces(int channel, const Eigen::Ref<const Eigen::ArrayXf>& delta,
                  Eigen::MatrixXf& forces) const;
  void add_work(int channel, const Eigen::MatrixXf& forces,
                Eigen::Ref<Eigen::ArrayXf> gradient) const;

  /// Adds it for each two of some channels, summed over frames from `first` on that are so far
  /// apart, each times its weight: to the rows and columns that the channels have in `sums`.
  void add_sums(const std::vector<int>& channels, Eigen::Index first, Eigen::Index apart,
                const Eigen::ArrayXf& weights, Eigen::MatrixXf& sums) const;

  /// Both: adds it times an error of `delta` in `channel` alone.
  void add_to_gradient(int channel, const Eigen::VectorXd& delta, Eigen::MatrixXd& gradient) const;

 private:
  Eigen::Index place_of(int channel) const { return place_[static_cast<std::size_t>(channel)]; }

  std::vector<int> channels_;  // for which it is not zero
  std::vector<int> place_;     // of each channel among them, or -1
  Eigen::Index width_ = 0;     // numbers a channel and frame
  // J and B: frames x width * channels_; J alone where nothing turns. Then C J - B and -J.
  Eigen::MatrixXf motions_;
  Eigen::MatrixXf forces_;
};

}  // namespace mocapress
